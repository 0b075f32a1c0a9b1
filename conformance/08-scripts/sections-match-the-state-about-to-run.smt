spec 8.16  The section of a state is used in the steps of that state, the step of the transition away included.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 1

[all_states]
G == 2: p = 99
G == 4: @stop

[A]
true: k = k + 1
true: @assert S == 1 and G <= 2   #! W0752

[B]
true: c = c + 1   #! W0701
true: @assert S == 2 and G >= 3   #! W0752
G == 4: @assert k == 8 and c == 9   #! W0750
