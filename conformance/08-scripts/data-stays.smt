spec 8.65  After the last row values stay, and the script does not end.

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
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 1000: @assert x == 2
G == 1000: @stop
