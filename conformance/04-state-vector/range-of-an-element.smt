spec 4.14  Elements of a state vector file may bear @range.

-- app.sv --
[R]
U64 G
U32 S
F64 a @range 0 40
F64 b
    @range -1.5
    +2e3
I8 c @range -0x10 16
F32 d @range 5 5
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
I8 c
F32 d
[A]
.step
    b = a + c + d
-- app.ss --
[options]
delta_t 1
[all_states]
true {
    a = 100
    c = 17
    d = -1
    @assert b == 116
    @stop
}
