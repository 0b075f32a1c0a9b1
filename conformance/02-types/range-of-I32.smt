spec 2.1  I32 holds -2147483648 to 2147483647 only.

-- app.sm --
[state_vector]
U64 G
U32 S
I32 low
I32 high
I32 below
I32 above
F64 one

[local]
I32 klow = -2147483648
I32 khigh = 2147483647

[Run]
.step
    low = -2147483648 * one
    high = 2147483647 * one
    below = (-2147483648) * 2 - one
    above = 2147483647 * 2 + one

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
1 above 2147483647
1 below -2147483648
1 high 2147483647
1 khigh 2147483647
1 klow -2147483648
1 low -2147483648
