# The flight as it should be: launch after 1 s, highest point of 1000 m after 15 s, 20 m/s under the drogue,
# 5 m/s under the main, landing on a hill 60 m above the pad. The altimeter is noisy by 2 m up and down.

[options]
delta_t 10

# The ascent is a parabola around its highest point; G / 1000 is the time in seconds.
[Pad]
G <= 1000: altitude = 0
G >  1000: altitude = 1000 - 5.1 * (G / 1000 - 15) * (G / 1000 - 15)

[Ascent]
true: altitude = 1000 - 5.1 * (G / 1000 - 15) * (G / 1000 - 15) + 2 - 4 * (floor(G / 20) * 20 == G)

# The drogue opens when the rocket has fallen 8 m, and no igniter has had current before.
true {
    @assert not drogueCharge or T > 14000
    @assert not mainCharge and not beacon
}

[Drogue]
true: altitude = altitude - 0.2
T == 0: @assert 15000 < G < 17000 and 975 < altitude < 1000
T < 1000: @assert drogueCharge and not mainCharge
T >= 1000: @assert not drogueCharge and not mainCharge

[Main]
true: altitude = max(altitude - 0.05, 60)
T == 0: @assert 235 < altitude < 255
T < 1000: @assert mainCharge and not drogueCharge
T >= 1000: @assert not mainCharge and not drogueCharge

[Landed]
true: @assert altitude == 60 and beacon and not mainCharge

[all_states]
G == 500: @assert S == Pad
G == 8000: @assert S == Ascent
G == 30000: @assert S == Drogue
G == 70000: @assert S == Main
G == 110000 {
    @assert S == Landed
    @stop
}
