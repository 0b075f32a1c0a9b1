spec 8.53  The seed is a whole number up to 2^53.

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
-- app.ss --
[options]
delta_t 10
seed 9007199254740994      #! E0767
[all_states]
at 10: @stop
