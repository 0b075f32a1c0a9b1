# The navigation believes that the rocket rises for ever: the last timer brings the parachute out.

[options]
delta_t    10
init_state Coast

[all_states]
true: velocity = 40
G == 11900: @assert S == Coast and parachuteMode == 0
G == 12050 {
    @assert S == Recovery
    @assert parachuteMode == 2
    @stop
}
