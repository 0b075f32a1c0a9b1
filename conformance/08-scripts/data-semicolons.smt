spec 8.56  The separator is the one that the header has most often.

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
t;"P;1, total";Q
0;1;3
10;2;4
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P;1, total"
y = "Q"
[all_states]
G == 10: @assert x == 2 and y == 4
G == 10: @stop
