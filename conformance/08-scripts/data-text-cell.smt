spec 8.57  A cell that is no number is an error.
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
10,n/a
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"    #! E0779 d.csv:3: 'n/a' is not a number
[all_states]
G == 30: @assert x == 1
G == 30: @stop
