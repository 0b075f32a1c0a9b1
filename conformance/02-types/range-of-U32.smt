spec 2.1  U32 holds 0 to 4294967295 only.

-- app.sm --
[state_vector]
U64 G
U32 S
U32 low
U32 high
U32 below
U32 above
F64 one

[local]
U32 klow = 0
U32 khigh = 4294967295

[Run]
.step
    low = 0 * one
    high = 4294967295 * one
    below = (0) * 2 - one
    above = 4294967295 * 2 + one

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
1 above 4294967295
1 below 0
1 high 4294967295
1 khigh 4294967295
1 klow 0
1 low 0
