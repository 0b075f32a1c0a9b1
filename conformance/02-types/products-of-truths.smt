spec 2.4  A true bool counts as the number 1: sums and products of it have no limit but that of F64.

-- app.sm --
[state_vector]
U64 G
U32 S
bool a
bool b
I64 x
I64 y
I32 z
bool large

[Run]
.step
    x = a * 2000000 * 2000000 + b
    y = a * 2147483647 + b * 2147483647
    z = a * 30000 + b * 30000
    large = b * 2147483647 * 2 > a * 4294967293

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    b = 1
    @assert x == 4000000000001
    @assert y == 4294967294
    @assert z == 60000
    @assert large
    @stop
}
