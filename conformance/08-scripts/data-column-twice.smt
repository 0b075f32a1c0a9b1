spec 8.56  A column occurs in the header exactly once.
expect error

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y @read_only
bool b @read_only
U8 n @read_only
bool out
F64 seen
[Run]
.step
    out = b
    seen = x + y + n
-- d.csv --
t,PT-101,Q,Q
0,1,2,3
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "PT-101"
y = "Q"    #! E0779 d.csv:1: 2 columns have the name
[all_states]
true: @stop
