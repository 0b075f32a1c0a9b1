spec 2.1  I8 holds -128 to 127 only.

-- app.sm --
[state_vector]
U64 G
U32 S
I8 low
I8 high
I8 below
I8 above
F64 one

[local]
I8 klow = -128
I8 khigh = 127

[Run]
.step
    low = -128 * one
    high = 127 * one
    below = (-128) * 2 - one
    above = 127 * 2 + one

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
1 above 127
1 below -128
1 high 127
1 khigh 127
1 klow -128
1 low -128
