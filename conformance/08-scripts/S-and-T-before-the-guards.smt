spec 8.14  Guards see the S and T of the state about to run, already in its first step.

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
delta_t 5

[all_states]
G == 5: p = 99
S == 2: c = c + 1   #! W0701
S == 2 and T == 0: k = 50
T == 5 and S == 1: ro = 1
G == 10: @assert S == 2 and c == 8 and k == 50 and ro == 1
G == 15: @assert c == 9 and T == 5
G == 15: @stop
