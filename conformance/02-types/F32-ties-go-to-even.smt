spec 2.18  16777217 is half-way between two F32 values and becomes 16777216; 16777219 becomes 16777220.

-- app.sm --
[state_vector]
U64 G
U32 S
F32 a
F32 b
F64 x

[Run]
.step
    a = x + 1
    b = x + 3

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 16777216
    @assert a == 16777216
    @assert b == 16777220
    @stop
}
