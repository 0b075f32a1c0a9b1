# The altimeter reads 0 from the fourth second of the flight on. That is no fall from 250 m: the drogue must wait for its timer,
# since at full speed it would tear. The main, afterwards, opens at once: its altitude is unknown.

[all_states]
true: altitude = max(0, 60 * (G / 1000 - 1))
G > 5.5 s: altitude = 0
at 19 s: @assert S == Ascent and not drogueCharge
at 20 s: @assert S == Drogue and drogueCharge
at 22.4 s: @assert S == Drogue and not mainCharge
at 22.7 s: @assert S == Main and mainCharge
at 23.7 s: @assert not mainCharge
at 23.7 s: @stop
