spec 8.46  An inner guard is evaluated where it appears, if the outer one was true when it was evaluated.

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
p == 0 {
    p = 5
    p == 5: n = n + 1
    p == 0: n = n + 100
    p = 6
    if p == 6: if n == 1: n = n + 10
    else: n = n + 1000
    p = 7
}
at 0: @assert p == 7 and n == 11
at 10: @assert p == 7 and n == 11
at 20 {
    p = 0
    p == 0 {
        p == 0 {
            @assert p == 8
        }
        else: @assert false
        p = 8
    }
}
p == 7: n = 11
else if p == 8 { p == 9: @assert false
                 else: n = 12 }
at 20: @assert n == 12
at 30: @stop
