spec 8.55  Settings and columns are in any order.
warn no-data-times

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
10,2
20,
20,9
-- app.ss --
[options]
delta_t 10
[data]
x = "P"
@compare y "P" tolerance 100
missing nan
on_bad_time skip
linear
time "t" ms
file "d.csv"
[all_states]
G == 20: @assert x == 0
G == 20: @stop
