# The tank leaks in the countdown: nothing is ever opened.

[options]
delta_t 10

[all_states]
G == 0: tankPressure = 40
G > 1000: tankPressure = max(0, 40 - (G - 1000) / 100)
G == 1000: tankPressure = 10            # one wild sample
true: @assert engineMode == 1 and parachuteMode == 1 and not flying
G == 1500: @assert S == Countdown
G == 1700: @assert S == Scrub
G == 20000: @stop
