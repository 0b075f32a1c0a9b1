# The velocity reads 0: at full speed, where the flaps would break off, and later while they are out.

[options]
delta_t 10

[all_states]
true {
    mayBrake      = true
    altitude      = 2000
    velocity      = 300
    brakePosition = brakeOrder
}
G >= 1000: velocity = 0
G < 3000: @assert S == Retracted and brakeOrder == 0
3000 <= G < 5000: velocity = 200
G == 4000: @assert S == Braking and brakeOrder == 1
G == 5000: @assert brakeOrder == 0
G == 6000 {
    @assert S == Retracted and brakeOrder == 0
    @stop
}
