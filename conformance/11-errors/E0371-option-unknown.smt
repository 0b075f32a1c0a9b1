spec 4.2, 8.1   An option that does not exist is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10 seconds  #! E0371 did you mean '10 s'?
init_stat Hold      #! E0371 did you mean 'init_state'?
[all_states]
G == 100: @stop
