spec 8.68  A machine with a step has no script with delta_t file.
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
[options]
step 10 ms
[Run]
.step
    out = b
    seen = x + y + n
-- d.csv --
t,P
0,1
10,2
-- app.ss --
[options]
delta_t file   #! E0778 declares a step
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
true: @stop
