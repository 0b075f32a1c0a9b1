# The flight as it should be: launch after 1 s, highest point of 1000 m after 15 s, 20 m/s under the drogue,
# 5 m/s under the main, landing on a hill 60 m above the pad. The altimeter is noisy by 2 m up and down.

[define]
t      = G / 1000 - 15            # s, from the highest point on
flight = 1000 - 5.1 * t * t       # a parabola around it

[Pad]
G > 1 s: altitude = flight
else: altitude = 0

[Ascent]
every 20 ms: altitude = flight - 2
else: altitude = flight + 2

# The drogue opens when the rocket has fallen 8 m, and no igniter has had current before.
true {
    @assert not drogueCharge or T > 14 s
    @assert not mainCharge and not beacon
}

[Drogue]
true: altitude = altitude - 0.2
T == 0: @assert 15 s < G < 17 s and 975 < altitude < 1000
T < 1 s: @assert drogueCharge and not mainCharge
T >= 1 s: @assert not drogueCharge and not mainCharge

[Main]
true: altitude = max(altitude - 0.05, 60)
T == 0: @assert 235 < altitude < 255
T < 1 s: @assert mainCharge and not drogueCharge
T >= 1 s: @assert not mainCharge and not drogueCharge

[Landed]
true: @assert altitude == 60 and beacon and not mainCharge

[all_states]
at 500 ms: @assert S == Pad
at 8 s: @assert S == Ascent
at 30 s: @assert S == Drogue
at 70 s: @assert S == Main
at 110 s: @assert S == Landed
at 110 s: @stop
