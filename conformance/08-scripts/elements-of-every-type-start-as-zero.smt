spec 8.12  Elements of every type.

-- app.sm --
[state_vector]
U64 G
U32 S
I32 a
F32 b
bool c
U64 d

[Run]
.step
    a = a

-- app.ss --
[options]
delta_t 1

[all_states]
a == 0 and b == 0 and c == 0 and d == 0: @assert true
a != 0 or b or c or d: @assert false
true: @stop
