spec 8.7  An else without items is an error.

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
at 0: p = 1
else { }                #! E0384
at 10 {
    p == 1 { }          #! E0384
}
at 20: @stop
