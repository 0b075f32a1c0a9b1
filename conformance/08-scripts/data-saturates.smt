spec 8.64  Values beyond the range of a type saturate, as inputs do.

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
0,255
10,300
20,-5
30,7.9
40,1e300
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
n = "P"
b = "P"
[all_states]
G == 0: @assert n == 255 and b
G == 10: @assert n == 255
G == 20: @assert n == 0
G == 30: @assert n == 7
G == 40: @assert n == 255
G == 40: @stop
