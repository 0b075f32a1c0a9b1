# The navigation knows nothing of the flight and the tank's sensor sticks: the accelerometer alone keeps the flight from being
# called off in the air, and both timers bring the parachute out all the same.

[options]
delta_t 10

[all_states]
at 0 {
    tankPressure = 40
    acceleration = 9.8
}
from 3 s to 6 s: acceleration = 36
after 6 s: acceleration = 0
at 3.5 s: @assert engineMode == 2
at 7.4 s: @assert S == Powered
at 7.55 s {
    @assert S == Coast
    @assert engineMode == 1 and parachuteMode == 1
}
at 11.4 s: @assert S == Coast
at 11.6 s: @assert S == Recovery and parachuteMode == 2
at 11.6 s: @stop
