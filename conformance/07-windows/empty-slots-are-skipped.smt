spec 7.13  An average of −0 samples is −0 while the window fills: adding an empty slot as 0 would make it 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_avg(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = -0.0
true: @assert 1 / x == -1/0
G == 6: @stop
