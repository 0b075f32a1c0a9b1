spec 8.46  An else follows its conditional directly.

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
[all_states]
at 0 {
    p = 1
    else: p = 2         #! E0318
}
at 20: @stop
