# The flight as it should be: 200 m high, the drogue falls with 18 m/s, the main with 5. The altimeter is noisy by half a metre.

[options]
delta_t 10

[Pad]
G <= 1000: altitude = 0
G >  1000: altitude = 200 - 4.905 * (G / 1000 - 7.4) * (G / 1000 - 7.4)
G < 1000: @assert not drogueCharge and not mainCharge

[Ascent]
true: altitude = 200 - 4.905 * (G / 1000 - 7.4) * (G / 1000 - 7.4) + 0.5 - (floor(G / 20) * 20 == G)
true: @assert not drogueCharge and not mainCharge

[Drogue]
true: altitude = altitude - 0.18
T == 0: @assert 7400 < G < 9000 and altitude > 190
T < 1000: @assert drogueCharge and not mainCharge
T >= 1000: @assert not drogueCharge and not mainCharge

[Main]
true: altitude = max(altitude - 0.05, 0)
T == 0: @assert 95 < altitude < 105
T < 1000: @assert mainCharge and not drogueCharge

[Descent]
true: altitude = max(altitude - 0.05, 0)
true: @assert not mainCharge and not drogueCharge

[all_states]
G == 40000 {
    @assert S == Descent and altitude == 0
    @stop
}
