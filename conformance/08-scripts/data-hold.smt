spec 8.62  hold has the value of the last row whose time is at most G.

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
9.9,2
10,3
10.1,4
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
hold
x = "P"
[all_states]
G == 0: @assert x == 1
G == 10: @assert x == 3
G == 20: @assert x == 4
G == 20: @stop
