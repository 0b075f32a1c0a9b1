spec 2.1  U8 holds 0 to 255 only.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 low
U8 high
U8 below
U8 above
F64 one

[local]
U8 klow = 0
U8 khigh = 255

[Run]
.step
    low = 0 * one
    high = 255 * one
    below = (0) * 2 - one
    above = 255 * 2 + one

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    one = 1
    @assert klow == low
    @assert khigh == high
    @assert below == low
    @assert above == high
    @stop
}

-- trace --
1 above 255
1 below 0
1 high 255
1 khigh 255
1 klow 0
1 low 0
