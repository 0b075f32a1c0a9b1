spec 8.68  After the last row no further step is possible.
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
-- app.ss --
[options]
delta_t file   #! E0780 the data ended at G = 10
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 0: @assert x == 1
G > 10: @stop
