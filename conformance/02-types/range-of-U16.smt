spec 2.1  U16 holds 0 to 65535 only.

-- app.sm --
[state_vector]
U64 G
U32 S
U16 low
U16 high
U16 below
U16 above
F64 one

[local]
U16 klow = 0
U16 khigh = 65535

[Run]
.step
    low = 0 * one
    high = 65535 * one
    below = (0) * 2 - one
    above = 65535 * 2 + one

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
1 above 65535
1 below 0
1 high 65535
1 khigh 65535
1 klow 0
1 low 0
