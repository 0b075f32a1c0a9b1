# The accelerometer sticks at 50 from lift-off on, and the navigation filter that lives on it says for ever that the rocket climbs.
# Burnout and parachutes come by the timers.

[all_states]
true {
    acceleration = 50
    velocity     = 100
    altitude     = 5000
}

[Powered]
true: @assert T <= 4510 and not mayBrake

[Coast]
T == 0: @assert G > 4700
true: @assert T <= 22010
T < 22000: @assert not deployParachutes and mayBrake

[Descent]
T == 0: @assert G > 26700
true: @assert deployParachutes and not mayBrake
T == 5000: @stop
