# The motor dies after two seconds, at 40 m. No airbrakes; parachutes at the highest point, for what they are worth.

[all_states]
G < 2000 {
    acceleration = 30
    velocity     = 20 * G / 1000
    altitude     = 10 * G * G / 1000000
}
after 2 s {
    acceleration = -1
    velocity     = 40 - 9.8 * (G / 1000 - 2)
    altitude     = max(0, 40 + 40 * (G / 1000 - 2) - 4.9 * (G / 1000 - 2) * (G / 1000 - 2))
}
true: @assert not mayBrake

[Coast]
T == 0: @assert 2000 < G < 2150
true: @assert not deployParachutes

[Descent]
T == 0: @assert G < 6250 and altitude > 110 and velocity <= 0
T < 5000: @assert deployParachutes
T == 5000: @stop
