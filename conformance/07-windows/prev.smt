spec 7.27, 7.28  prev(x) is x of the step before, whatever state was active; in the first step it is x.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
F64 c
I16 q
I16 d
bool on
bool e
[define]
change = p - prev(p)
[Run]
.step
    a = prev(p)
    b = change
    d = prev(q - 1)
    e = prev(on)
    T > 1: -> Wait
[Wait]
.step
    T > 1: -> Again
[Again]
.step
    c = prev(prev(p) + 1) + roll_max(prev(p), 2)
    a = prev(p)

-- app.ss --
[options]
delta_t 1
[all_states]
true {
    p = -G * G
    q = -3 * G
    on = G == 1
}
G == 0: @assert a == 0 and b == 0 and d == -1 and not e
G == 1: @assert a == 0 and b == -1 and d == -1 and not e
G == 2: @assert a == -1 and b == -3 and d == -4 and e
G == 6: @assert a == -25 and c == -31
G == 6: @assert S == Again
G == 6: @stop
