spec 8.64  G, S and T have no columns.
expect error

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
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
G = "P"    #! E0214
z = "P"    #! E0204 z
[all_states]
true: @stop
