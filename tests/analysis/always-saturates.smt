# The value can be worked out only so far; where all of it lies outside the type, the variable always gets the limit.
warn always-saturates no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
U8 n @read_only
F64 p @read_only
U8 x
I8 y
U8 z
F32 f
F64 d
bool b
[local]
U16 base = 0
[Hold]
.entry
    base = 500
.step
    x = n + 300               #! W0411 'x' is U8 and always stores 255: this value is from 300 to 555
    y = -n - 200              #! W0411 always stores -128
    z = base                  #! W0411 this value is 500
    p > 1000: z = p           #! W0411 from 1000.0
    f = n * 1e39 + 1e39       #! W0411 'f' is F32
    d = n * 1e39 + 1e39
    x = n * 2
    x = n + 255
    y = -n - 0.5
    z = 0 - n / 256
    x = p
    b = n + 300
    x < 255: x = x + 1
