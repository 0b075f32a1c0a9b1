spec 7.9, 7.12  After the index has wrapped the pairs are those of the slots: slot 0 has the newest sample and pairs with slot 1, the oldest.

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
G == 0: p = 7
G == 1: p = 1e16
G == 2: p = 1
G == 3: p = 1
G == 4: p = -1e16
G == 4: @assert x == (-1e16 + 1e16 + (1 + 1)) / 4
G == 4: @stop
