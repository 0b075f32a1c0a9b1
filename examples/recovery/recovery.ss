# The flight as it should be: 200 m high, the drogue falls with 18 m/s, the main with 5. The altimeter is noisy by half a metre.

[define]
t      = G / 1000 - 7.4             # s, from the highest point on
flight = 200 - 4.905 * t * t

[Pad]
G > 1 s: altitude = flight
else: altitude = 0
G < 1 s: @assert not drogueCharge and not mainCharge

[Ascent]
every 20 ms: altitude = flight - 0.5
else: altitude = flight + 0.5
true: @assert not drogueCharge and not mainCharge

[Drogue]
true: altitude = altitude - 0.18
T == 0: @assert 7.4 s < G < 9 s and altitude > 190
T < 1 s: @assert drogueCharge and not mainCharge
T >= 1 s: @assert not drogueCharge and not mainCharge

[Main]
true: altitude = max(altitude - 0.05, 0)
T == 0: @assert 95 < altitude < 105
T < 1 s: @assert mainCharge and not drogueCharge

[Descent]
true: altitude = max(altitude - 0.05, 0)
true: @assert not mainCharge and not drogueCharge

[all_states]
at 40 s: @assert S == Descent and altitude == 0
at 40 s: @stop
