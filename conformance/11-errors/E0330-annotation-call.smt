spec 8.20   @stop takes no arguments, and no parentheses.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[A]
.step
    x = 1
-- app.ss --
[options]
delta_t 1
[all_states]
G == 3: @stop()     #! E0330 write @stop
