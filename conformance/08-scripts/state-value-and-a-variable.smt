spec 8.44  After `state` a name is that of a state, whatever else has it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 Burn
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
[all_states]
at 0: Burn = 9
state Burn: @assert Burn == 9 and T == G - 40
at 60: @assert state Burn
at 60: @stop
