spec 8.60  A missing cell has the value of the row before.

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
0,,4
10,2, 
20,nan,5
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
y = "Q"
[all_states]
G == 0: x = 7
G == 0: @assert x == 7 and y == 4
G == 10: @assert x == 2 and y == 4
G == 20: @assert x == 2 and y == 5
G == 20: @stop
