spec 1.27   In a script, too, several statements after a condition on one line need braces.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q @read_only
[Hold]
.step
    p = q
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 5; p = 3                  #! E0109 in braces
G == 10: p = 5; @assert q > 2         #! E0109 in braces
G == 20: p = 5, @assert q > 2         #! E0330 in braces
G == 30: @assert q > 2; @assert p > 3; @stop     #! E0109 in braces
G == 40: @assert q > 2 @stop          #! E0330 in braces
G > 50: @stop
