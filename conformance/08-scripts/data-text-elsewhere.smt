spec 8.57  Only the columns of the script are read.

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
t,P,note
0,1,start
10,2,1e999
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 10: @assert x == 2
G == 10: @stop
