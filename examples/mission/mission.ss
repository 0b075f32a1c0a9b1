# The flight as it should be: plug out at 1 s, lift-off at 2 s, burnout at 6 s, highest point at 21 s.

[all_states]
at 0 {
    umbilical    = true
    acceleration = 9.8
}
at 1 s: umbilical = false
at 1.5 s: acceleration = 60           # a knock at the rocket: 50 ms
at 1.55 s: acceleration = 9.8
from 2 s to 6 s {
    acceleration = 50
    velocity     = 40 * (G / 1000 - 2)
    altitude     = 20 * (G / 1000 - 2) * (G / 1000 - 2)
}
from 3 s to 3.5 s: acceleration = -5    # the motor coughs: half a second
at 5 s: acceleration = -5           # and once more, for one sample
from 6 s to 21 s {
    acceleration = 0 - velocity / 20
    velocity     = 160 - 10.6 * (G / 1000 - 6)
    altitude     = 320 + 160 * (G / 1000 - 6) - 5.3 * (G / 1000 - 6) * (G / 1000 - 6)
}
at 15 s: velocity = -500            # the navigation filter jumps, once
after 21 s {
    velocity     = -20
    altitude     = max(40, altitude - 0.2)   # a hill, 40 m above the pad
    acceleration = 9.8
}
true: @assert (S == Coast or not mayBrake) and (S == Descent or not deployParachutes)

[Pad]
true: @assert G <= 2100

[Powered]
T == 0: @assert 2000 < G < 2150
true: @assert not mayBrake and not deployParachutes and G <= 6150

[Coast]
T == 0: @assert 6000 < G < 6150
G < 21000: @assert mayBrake and not deployParachutes
true: @assert G <= 21100

[Descent]
T == 0: @assert deployParachutes and not mayBrake and 21000 < G < 21150

[Landed]
true: @assert altitude == 40 and not deployParachutes

[all_states]
at 3.6 s: @assert S == Powered
at 10 s: @assert S == Coast
at 60 s: @assert S == Descent
at 110 s: @assert S == Landed
at 110 s: @stop
