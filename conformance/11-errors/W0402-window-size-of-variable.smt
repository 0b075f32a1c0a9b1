spec 7.3   A local that is also assigned is accepted as window size, with a warning.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
U16 n = 20
U16 m = 2 * n
[Hold]
.step
    x = roll_avg(x, n + m)    #! W0402 'n' is declared here
    x = roll_avg(x, m)
    n = 50
