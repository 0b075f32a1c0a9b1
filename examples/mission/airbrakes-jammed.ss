# The drive does not move. Less than a second after the order the brakes are given up, and never tried again.

[all_states]
true {
    mayBrake = true
    velocity = 200
    altitude = 900
}
at 5 s: mayBrake = false

[Braking]
true: @assert T <= 900 ms
T < 800 ms: @assert brakeOrder == 1

[Jammed]
true: @assert G < 10 s and brakeOrder == 0
at 2 s: brakePosition = 1
at 9 s: @stop
