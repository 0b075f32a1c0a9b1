spec 8.66  The column of a @compare has the value of the last row, also with `linear`.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[Run] @safe
.step
    y = x
-- d.csv --
t,X,Y
0,0,0
20,10,0
40,30,10
-- app.ss --
[options]
delta_t 10
[local]
F64 before = 0
[data]
file "d.csv"
time "t" ms
linear
x = "X"
@compare before "X" delay 10 ms
[all_states]
at 10: before = 0
at 10: @assert x == 5 and y == 5
at 20: before = 0
at 30: before = 10
at 30: @assert x == 20
at 50: before = 30
at 40: before = 10
at 50: @stop
