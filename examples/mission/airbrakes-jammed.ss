# The drive does not move. Less than a second after the order the brakes are given up, and never tried again.

[options]
delta_t 10

[all_states]
true {
    mayBrake = true
    velocity = 200
    altitude = 900
}
G == 5000: mayBrake = false

[Braking]
true: @assert T <= 900
T < 800: @assert brakeOrder == 1

[Jammed]
true: @assert G < 10000 and brakeOrder == 0
G == 2000: brakePosition = 1
G == 9000: @stop
