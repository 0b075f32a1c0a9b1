spec 3.15  0 - x is +0 for a zero x of any type, and -x is not.

-- app.sm --
[state_vector]
U64 G
U32 S
I8   a
U16  b
I32  c
U64  d
bool e
F32  f
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  r9
I32  z

[Run]
.step
    r1 = 0 - a
    r2 = 0 - b
    r3 = 0 - c
    r4 = 0 - d
    r5 = 0 - e
    r6 = 0 - f
    r7 = 0 - T
    r8 = -a
    z = 0
    r9 = z - b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == 1/0
    @assert 1 / r6 == 1/0
    @assert 1 / r7 == 1/0
    @assert 1 / r8 == -1/0
    @assert 1 / r9 == 1/0
    @stop
}
