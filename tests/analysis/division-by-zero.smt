# By what is always 0, as far as guards, stores and initial values tell.
warn division-by-zero no-dead-store no-constant-guard
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
U8 n @read_only
F64 x
F64 y
[local]
F64 zero = 0
F64 some = 0
[Hold]
.entry
    x = p / some              #! W0407
    some = 3
.step
    zero = 0
    x = p / zero              #! W0407
    n == 0: y = p / n         #! W0407
    y = p / (n * 0)           #! W0407
    x = roll_avg(p / (3 - 3), 4)      #! W0407
    x = p / n
    x = p / some
    some = some + 1
