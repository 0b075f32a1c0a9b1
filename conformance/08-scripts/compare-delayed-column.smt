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
t,CMD
0,1
20,0
40,1
60,1
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
@compare out "CMD" delay 20 ms
[all_states]
G == 0: b = false
G == 20: b = true
G == 40: b = false
G == 60: b = true
G == 80: @stop
