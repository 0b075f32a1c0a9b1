spec 6.18   Transitions that an earlier one leaves something over for.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool ready
U8 cmd
[local]
F64 x = 0
[Narrow]
.step
    p > 20: -> A
    p > 10: -> B
    p < 5: -> C
    p < 8: -> B
[A]
.step
    p > q: -> B
    p > q - 5: -> C
    q > p: -> D
    roll_avg(p, 3) > 5: -> B
    roll_avg(p, 4) > 6: -> C
[B]
.step
    p > 10: x = 1
    p > 20: -> C
    x = x + q
    x > 3: -> D
    x = x * 2
    x > 4: -> C
    q > 5 and ready: -> A
    q > 5: -> C
    q > 2 { p > 3: -> A }
    q > 4: -> A
[C]
.entry
    p > 10: -> A
.step
    p > 20: -> B
    cmd == 1: -> A
    cmd == 2: -> B
    cmd == 3: -> D
[D]
.step
    p > 10 {
        p = q * 2
        p < q: -> E
    }
    p > 12: -> A
    if q > 5 { -> B } else if q > 4 { -> A } else { -> C }
[E]
.step
    G > 100 and p > 10: -> A
    p > 11: -> B
