spec 1.4  Files whose lines end with carriage return and line feed are read like any other.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 n @read_only

[local]
F64 x = 5
F64 y = 6

[Run]
.step
    x = x + 1  # one more
    if x > 1 {
        y = 7
    }
    else: y = 8
    (x
     > 100): y = 9

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 6
    @assert y == 7
    @stop
}
