spec 3.36, 3.39   The sign of a zero counts in pow and atan2, also where the value is a whole number.

-- app.sm --
[state_vector]
U64 G
U32 S
I8  zero
I8  exponent
I8  power
I8  other
I8  angle

[Run]
.entry
    exponent = -1
.step
    power = pow(-zero, exponent)
    other = pow(-zero, sign(exponent))
    angle = atan2(-zero, exponent)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    @assert power == -128
    @assert other == -128
    @assert angle == -3
    @stop
}
