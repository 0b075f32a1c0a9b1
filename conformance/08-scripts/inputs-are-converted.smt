spec 8.10, 2.13  Inputs are stored by the same conversions as assignments.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
F32 f
bool b
I16 i

[Run]
.step
    n = n

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    n = 300
    f = 0.1
    b = 0.5
    i = -1.9
    @assert n == 255 and f == 0.10000000149011612 and b == 1 and i == -1
    @stop
}
