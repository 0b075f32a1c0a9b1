spec 8.70  Rows are read one row ahead of the step.
expect fail

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
t,P
0,1
10,2
20,3
25,y
-- app.ss --
[options]
delta_t 1
[data]
file "d.csv"
time "t" ms
x = "P"   #! E0779 d.csv:5: 'y' is not a number
[all_states]
G == 20: @assert x == 2
G == 20: @stop
