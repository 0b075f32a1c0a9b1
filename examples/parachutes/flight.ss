# A good flight: three seconds of thrust, the top 23 seconds after launch at 1.9 km, down under both parachutes.

[options]
delta_t 20

[all_states]
G == 0 {
    armed        = true
    altitude     = 0
    acceleration = 9.8
}
# Thrust from 2 s to 5 s: 60 m/s^2 upward, which the rocket feels as 69.8.
2000 <= G < 5000 {
    acceleration = 69.8
    altitude     = 30 * (G / 1000 - 2) * (G / 1000 - 2)
}
# No thrust any more: a thrown stone.
G >= 5000: acceleration = -1

# A spike before launch and a wild reading on the way up must not matter.
G == 1000: acceleration = 200
G == 1020: acceleration = 9.8

# Never both charges at once, and none before the top.
true: @assert not (drogueCharge and mainCharge)

[Pad]
true: @assert G <= 2200           # launch is noticed within a fifth of a second

[Boost]
true: @assert not drogueCharge and not mainCharge
true: @assert G <= 5200           # so is the end of thrust

[Coast]
true: altitude = 270 + 180 * (G / 1000 - 5) - 4.9 * (G / 1000 - 5) * (G / 1000 - 5)
G == 12000: altitude = 9000
true: @assert not drogueCharge and not mainCharge
true: @assert G <= 24600          # the top is at 23.4 s; one second later it falls with 12 m/s

[Drogue]
true: altitude = altitude - 20 * 0.02
true: @assert drogueCharge == (T < 1000) and not mainCharge
true: @assert altitude >= 298      # the main comes in time

[Main]
true: altitude = max(0, altitude - 5 * 0.02)
true: @assert not drogueCharge and mainCharge == (T < 1000)

[Landed]
true: @assert altitude == 0 and not drogueCharge and not mainCharge
T > 1000: @stop
