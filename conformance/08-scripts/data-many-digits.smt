spec 8.57  A number is rounded to the nearest F64, however many digits it has.

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
0,0.1000000000000000055511151231257827021181583404541015625
10,9007199254740993.0000000000000000000000000000000000000000001
20,9007199254740993
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 0: @assert x == 0.1
G == 10: @assert x == 9007199254740994
G == 20: @assert x == 9007199254740992
G == 20: @stop
