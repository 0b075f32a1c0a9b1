spec 8.57  inf is infinite.
warn no-division-by-zero

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
0,inf,-Infinity
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
y = "Q"
[all_states]
G == 0: @assert x == 1 / 0 and y == -1 / 0
G == 0: @stop
