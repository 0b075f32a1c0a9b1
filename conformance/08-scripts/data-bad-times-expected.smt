spec 8.59  With on_bad_time skip, no warning reports rows without a later time.

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
0,1
0,2
10,3
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
on_bad_time skip
x = "P"
[all_states]
G == 10: @assert x == 3
G == 10: @stop
