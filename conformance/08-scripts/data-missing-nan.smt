spec 8.60  With missing nan a missing cell is NaN, which is stored as an assignment stores it.

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
0,1,4
10,,5
20,3,6
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
missing nan
x = "P"
n = "P"
y = "Q"
[all_states]
G == 0: @assert x == 1 and n == 1
G == 10: @assert x == 0 and n == 0 and y == 5
G == 20: @assert x == 3
G == 20: @stop
