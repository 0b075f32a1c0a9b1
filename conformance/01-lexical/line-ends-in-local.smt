spec 1.33  In [local] line ends are blanks up to the initial value and between annotations; the value ends at a line end or an annotation.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 z

[local]
F64
a
=
1

F64 b
    = (1 +
 2) @read_only F64 c = -4 @read_only

[Run]
.step
    x = a
    y = b
    z = c

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @assert y == 3
    @assert z == -4
    @stop
}
