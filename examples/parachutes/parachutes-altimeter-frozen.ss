# The altimeter stops at 400 m and reads that for ever. The timers open both parachutes.

[all_states]
true: altitude = min(400, max(0, 60 * (G / 1000 - 1)))
at 19 s: @assert S == Ascent and not drogueCharge
at 20 s: @assert S == Drogue and drogueCharge
at 64 s: @assert S == Drogue and not mainCharge
at 65 s: @assert S == Main and mainCharge
at 90 s: @stop
