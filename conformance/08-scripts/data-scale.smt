spec 8.61  The value is cell * k + c, each operation rounded.

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
0,3
10,-1
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P" @scale 0.1 @offset -4
y = "P" @offset 1
n = "P" @scale 2
[all_states]
G == 0: @assert x == 3 * 0.1 + -4 and y == 4 and n == 6
G == 10: @assert x == -1 * 0.1 + -4 and y == 0 and n == 0
G == 10: @stop
