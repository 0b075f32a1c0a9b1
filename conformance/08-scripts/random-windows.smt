spec 8.42, 8.49  Windows of a script can sample random numbers.

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
true: n = random(0, 1)
at 20: @assert roll_max(random(7, 7), 3) == 7
at 30: @assert prev(random(0, 8)) != random(0, 8)
at 40: @stop
