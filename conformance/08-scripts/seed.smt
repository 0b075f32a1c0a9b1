spec 8.53  The seed is a whole number, 0 without the option.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- b.ss --
[options]
delta_t 10
[all_states]
at 0: @assert random(0, 4294967296) == 257813417
at 10: @stop
-- c.ss --
[options]
delta_t 10
seed 9007199254740992
[all_states]
at 0: @assert random(0, 4294967296) == 2514952854
at 10: @stop
-- app.ss --
[options]
delta_t 10
seed 41
seed 0
[all_states]
at 0: @assert random(0, 4294967296) == 257813417
at 10: @stop
