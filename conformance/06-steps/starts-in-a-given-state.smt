spec 6.1, 8.2  A machine may be started in any of its states.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    G == 2: -> B

[B]
.step
    x = S

[C]
.step
    x = 30

-- app.ss --
[options]
delta_t 1
init_state C

[all_states]
G == 0: @assert S == 3 and x == 30 and T == 0
G == 0: @stop
