# The velocity jumps. Single samples of 0 at full speed must not open the airbrakes; and when the rocket is too fast again
# while they are out, they come in at once.

[options]
delta_t 10

[all_states]
true {
    mayBrake = true
    velocity = 300
    altitude = 900
}
G == 1000: velocity = 0
G == 1010: velocity = 0
G >= 3000: velocity = 230
G == 4000: velocity = 250
true: brakePosition = brakeOrder
G < 3000: @assert S == Retracted and brakeOrder == 0
G == 3030: @assert S == Braking and brakeOrder == 1
G == 4000: @assert S == Braking and brakeOrder == 0
G == 4010 {
    @assert S == Retracted
    @stop
}
