spec 7.20  The range of equal samples is +0, of infinities and of −0 too; of 0 and −0 as well.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
bool zero

[Run]
.step
    x = roll_range(p, 2)
    zero = roll_range(p, 2) == 0

-- app.ss --
[options]
delta_t 1

[all_states]
G < 2: p = 1/0
G >= 2: p = -1/0
G >= 4: p = -0.0
G == 6: p = 0
G == 7: p = 3
true: @assert zero == (G != 2 and G != 4 and G != 7)
G != 2 and G != 4 and G != 7: @assert x == 0 and 1 / x == 1/0
G == 2 or G == 4: @assert x == 1/0
G == 7: @assert x == 3
G == 7: @stop
