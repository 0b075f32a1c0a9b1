spec 8.45  `state` is a name where no name follows, before `steps` as a second argument, and before `within`.

-- app.sm --
[state_vector]
U64 G
U32 state @alias S
F64 x
F64 p

[local]
F64 size = 2 @read_only
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
[local]
F64 level = 3 @read_only
F64 steps = 0
[all_states]
state == 1: p = state
at 20: @assert roll_min(G, size steps) == 10 and x == 1
at 0: @expect state within 30
every 10: steps = state
at 30: @expect state Burn within 20
(state
) > 1: steps = 7
at 60: @assert steps == 7
at 60: @stop
