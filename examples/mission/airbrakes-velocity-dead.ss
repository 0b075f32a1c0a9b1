# The velocity reads 0: at full speed, where the flaps would break off, and later while they are out.

[all_states]
true {
    mayBrake      = true
    altitude      = 2000
    velocity      = 300
    brakePosition = brakeOrder
}
after 1 s: velocity = 0
G < 3 s: @assert S == Retracted and brakeOrder == 0
from 3 s to 5 s: velocity = 200
at 4 s: @assert S == Braking and brakeOrder == 1
at 5 s: @assert brakeOrder == 0
at 6 s: @assert S == Retracted and brakeOrder == 0
at 6 s: @stop
