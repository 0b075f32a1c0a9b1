spec 8.63  linear is a + (b - a) * ((t - ta) / (tb - ta)); bools hold.

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
t,P,B
0,1,0
30,2,1
40,-2,0
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
linear
x = "P"
b = "B"
n = "P" @scale 10
[all_states]
G == 10: @assert x == 1 + 1 * (10 / 30) and not b and n == 13
G == 20: @assert x == 1 + 1 * (20 / 30)
G == 30: @assert x == 2 and b and n == 20
G == 40: @assert x == -2 and not b and n == 0
G == 60: @assert x == -2
G == 60: @stop
