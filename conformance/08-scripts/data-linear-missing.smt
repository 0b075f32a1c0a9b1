spec 8.63  linear interpolates to the value of 8.60.

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
t,P,Q
0,,1
20,4,
40,8,5
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
linear
x = "P"
y = "Q"
[all_states]
G == 0: x = 9
G == 10: @assert x == 9 and y == 1
G == 20: @assert x == 4 and y == 1
G == 30: @assert x == 6 and y == 3
G == 40: @stop
