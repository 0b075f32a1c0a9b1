spec 2.1  I16 holds -32768 to 32767 only.

-- app.sm --
[state_vector]
U64 G
U32 S
I16 low
I16 high
I16 below
I16 above
F64 one

[local]
I16 klow = -32768
I16 khigh = 32767

[Run]
.step
    low = -32768 * one
    high = 32767 * one
    below = (-32768) * 2 - one
    above = 32767 * 2 + one

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
1 above 32767
1 below -32768
1 high 32767
1 khigh 32767
1 klow -32768
1 low -32768
