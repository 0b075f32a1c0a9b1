# The navigation knows nothing of the flight and the tank's sensor sticks: the accelerometer alone keeps the flight from being
# called off in the air, and both timers bring the parachute out all the same.

[options]
delta_t 10

[all_states]
G == 0 {
    tankPressure = 40
    acceleration = 9.8
}
3000 <= G < 6000: acceleration = 36
G >= 6000: acceleration = 0
G == 3500: @assert engineMode == 2
G == 7400: @assert S == Powered
G == 7550 {
    @assert S == Coast
    @assert engineMode == 1 and parachuteMode == 1
}
G == 11400: @assert S == Coast
G == 11600 {
    @assert S == Recovery
    @assert parachuteMode == 2
    @stop
}
