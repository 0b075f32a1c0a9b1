spec 8.64  Columns are written before windows sample and before inputs, which can overwrite them.

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
-- app.ss --
[options]
delta_t 10
[local]
F64 mine = 0
[data]
file "d.csv"
time "t" ms
x = "P"
mine = "P"
[all_states]
roll_max(x, 1) == 3: @assert G == 20
G == 10: x = x * 10
G == 10: @assert x == 20 and mine == 2
G == 20: @assert x == 3
G == 20: @stop
