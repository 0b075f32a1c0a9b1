spec 8.55  A tolerance is at least 0, and a delay a whole number of units.
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
@compare x "P" tolerance -1   #! E0777 tolerance
@compare y "P" delay 0.5 ms   #! E0777 whole number of ms
[all_states]
true: @stop
