spec 2.1  U64 holds 0 to 18446744073709551615 only.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 low
U64 high
U64 below
U64 above
F64 one

[local]
U64 klow = 0
U64 khigh = 18446744073709551615

[Run]
.step
    low = 0 * one
    high = 18446744073709551615 * one
    below = (0) * 2 - one
    above = 18446744073709551615 * 2 + one

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
1 above 18446744073709551615
1 below 0
1 high 18446744073709551615
1 khigh 18446744073709551615
1 klow 0
1 low 0
