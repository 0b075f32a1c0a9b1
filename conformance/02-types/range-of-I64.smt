spec 2.1  I64 holds -9223372036854775808 to 9223372036854775807 only.

-- app.sm --
[state_vector]
U64 G
U32 S
I64 low
I64 high
I64 below
I64 above
F64 one

[local]
I64 klow = -9223372036854775808
I64 khigh = 9223372036854775807

[Run]
.step
    low = -9223372036854775808 * one
    high = 9223372036854775807 * one
    below = (-9223372036854775808) * 2 - one
    above = 9223372036854775807 * 2 + one

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
1 above 9223372036854775807
1 below -9223372036854775808
1 high 9223372036854775807
1 khigh 9223372036854775807
1 klow -9223372036854775808
1 low -9223372036854775808
