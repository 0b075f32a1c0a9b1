spec 13.9  A name that is a state and a variable is the state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool B @read_only
[A]
.step
    p == 1: -> C
[B]
[C] @safe

-- app.rq --
R1 "b"  never B before C       #! W1303 write (B) for the variable  #! W1300
R2 "c"  never C before (B)

-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: B = true
G == 10: p = 1
G == 20: @stop
