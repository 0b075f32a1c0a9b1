spec 5.10   An initial value uses no elements and no T.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 a = x                     #! E0406 but 'x' is an element
F64 b = 2 * G                 #! E0406 'G'
F64 c = T + 1                 #! E0406 the time in the state
F64 d = max(c, a)
[Hold]
.step
    x = roll_avg(d, d)
