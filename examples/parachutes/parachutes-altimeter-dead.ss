# The altimeter reads 0 from the fourth second of the flight on. That is no fall from 250 m: the drogue must wait for its timer,
# since at full speed it would tear. The main, afterwards, opens at once: its altitude is unknown.

[options]
delta_t 10

[all_states]
true: altitude = max(0, 60 * (G / 1000 - 1))
G > 5500: altitude = 0
G == 19000: @assert S == Ascent and not drogueCharge
G == 20000: @assert S == Drogue and drogueCharge
G == 22400: @assert S == Drogue and not mainCharge
G == 22700: @assert S == Main and mainCharge
G == 23000: @stop
