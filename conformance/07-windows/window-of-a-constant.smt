spec 7.11, 7.4  A window of a number is allowed; its average is that number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 k = 2.5 @read_only

[Run]
.step
    x = roll_avg(k + 1, 3) + roll_range(7, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
true: @assert x == 3.5
G == 4: @stop
