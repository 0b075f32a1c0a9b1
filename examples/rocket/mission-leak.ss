# The tank leaks in the countdown: nothing is ever opened.

[options]
delta_t 10

[all_states]
at 0: tankPressure = 40
G > 1000: tankPressure = max(0, 40 - (G - 1000) / 100)
at 1 s: tankPressure = 10            # one wild sample
true: @assert engineMode == 1 and parachuteMode == 1 and not flying
at 1.5 s: @assert S == Countdown
at 1.7 s: @assert S == Scrub
at 20 s: @stop
