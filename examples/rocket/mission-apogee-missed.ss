# The navigation believes that the rocket rises for ever: the last timer brings the parachute out.

[options]
delta_t    10
init_state Coast

[all_states]
true: velocity = 40
at 11.9 s: @assert S == Coast and parachuteMode == 0
at 12.05 s: @assert S == Recovery and parachuteMode == 2
at 12.05 s: @stop
