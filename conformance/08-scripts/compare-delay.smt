spec 8.66  With a delay d, the column is that of G - d, from G = d on.

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
t,B,OUT
0,0,1
20,1,0
40,0,1
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
b = "OUT"
@compare out "OUT"
@compare out "OUT" delay 0 ms
[all_states]
G == 10: @assert out
G == 30: @stop
