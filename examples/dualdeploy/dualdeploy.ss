# The flight as it should be, to 1500 m. The script plays the plant.

[all_states]
G == 0: armed = true
G <= 2 s: altitude = 0
G > 2 s and flight.S != Drogue and flight.S != Main: altitude = 1500 - 4.905 * (G / 1000 - 19.5) * (G / 1000 - 19.5)
flight.S == Drogue: altitude = altitude - 0.25
flight.S == Main: altitude = max(altitude - 0.06, 0)
true: @assert not (drogueFire and mainFire) "one igniter at a time"

[flight.Ascent]
true: @assert drogue.S == Waiting and main.S == Waiting

[flight.Drogue]
flight.T == 0: @assert 19.5 s < G < 22 s and altitude > 1480
flight.T == 500 ms: @assert drogueFire and drogue.S == Firing and main.S == Waiting

[drogue.Fired]
drogue.T == 0: @assert not drogueFire

[flight.Main]
flight.T == 0: @assert 240 < altitude < 260 and drogue.S == Fired
flight.T == 20 ms: @assert mainFire

[main.Fired]
main.T == 0: @assert not mainFire and not drogueFire
main.T == 1 s: @stop
