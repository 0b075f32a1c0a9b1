# The velocity jumps. Single samples of 0 at full speed must not open the airbrakes; and when the rocket is too fast again
# while they are out, they come in at once.

[all_states]
true {
    mayBrake = true
    velocity = 300
    altitude = 900
}
at 1 s: velocity = 0
at 1.01 s: velocity = 0
after 3 s: velocity = 230
at 4 s: velocity = 250
true: brakePosition = brakeOrder
G < 3 s: @assert S == Retracted and brakeOrder == 0
at 3.03 s: @assert S == Braking and brakeOrder == 1
at 4 s: @assert S == Braking and brakeOrder == 0
at 4.01 s: @assert S == Retracted
at 4.01 s: @stop
