# A flight whose altimeter breaks in the fourth second, while the rocket climbs at 30 m/s, and reads `reading` from then on. That is no
# fall: the drogue would tear. The drogue opens by its timer, and so does the main.

[define]
t      = G / 1000 - 7.4             # s, from the highest point on
flight = 200 - 4.905 * t * t

[local]
F64 reading = 0

[all_states]
after 4 s: altitude = reading
else: altitude = max(0, flight)
at 4 s: @assert S == Ascent
G < 12 s: @assert not drogueCharge
true: @assert not mainCharge or S == Main

[Drogue]
T == 0: @assert 13 s < G < 13.5 s
T < 9 s: @assert not mainCharge

[Main]
T == 0: @assert 22 s < G < 22.6 s
T == 1 s: @stop
