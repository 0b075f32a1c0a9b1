# The altimeter stops at 400 m and reads that for ever. The timers open both parachutes.

[options]
delta_t 10

[all_states]
true: altitude = min(400, max(0, 60 * (G / 1000 - 1)))
G == 19000: @assert S == Ascent and not drogueCharge
G == 20000: @assert S == Drogue and drogueCharge
G == 64000: @assert S == Drogue and not mainCharge
G == 65000: @assert S == Main and mainCharge
G == 90000: @stop
