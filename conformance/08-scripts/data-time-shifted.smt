spec 8.58  The first row has the time 0, and times are converted exactly.

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
1700000000.1,1
1700000000.11,2
1700000000.119,3
-- app.ss --
[options]
delta_t 1
[data]
file "d.csv"
time "t" s
x = "P"
[all_states]
G == 9: @assert x == 1
G == 10: @assert x == 2
G == 18: @assert x == 2
G == 19: @assert x == 3
G == 20: @stop
