spec 2.16, 2.6  A counter counts up to its end and stays there, whatever its type.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 a
I8 b
U16 c
F32 f
I16 d

[Run]
.step
    a = a + 100
    b = b - 50
    c = c + 30000
    d = d - 20000
    f = f + 8388608

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert a == 200 and b == -100 and c == 60000 and d == -32768 and f == 16777216
G == 2: @assert a == 255 and b == -128 and c == 65535 and f == 25165824
G == 5: @assert a == 255 and b == -128 and c == 65535 and d == -32768
G == 5: @stop
