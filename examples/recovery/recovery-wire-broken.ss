# The altimeter loses its wire in the fourth second, while the rocket climbs at 30 m/s, and reads -50 m. That is no fall: the drogue would tear.
# The drogue opens by its timer, and so does the main.

[options]
delta_t 10

[all_states]
G < 4000: altitude = max(0, 200 - 4.905 * (G / 1000 - 7.4) * (G / 1000 - 7.4))
G >= 4000: altitude = -50
G == 4000: @assert S == Ascent
G < 12000: @assert not drogueCharge
true: @assert not mainCharge or S == Main

[Drogue]
T == 0: @assert 13000 < G < 13500
T < 9000: @assert not mainCharge

[Main]
T == 0: @assert 22000 < G < 22600
T == 1000: @stop
