spec 8.1, 8.4   A section of a script that begins with an option is [options].

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
[Options]           #! E0342 did you mean '[options]'?
delta_t 10
[All_States]        #! E0501 did you mean '[all_states]'?
G == 100: @stop
