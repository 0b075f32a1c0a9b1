spec 8.54  A machine with a state data has no recorded data.
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
[data]
.step
    out = b
    seen = x + y + n
-- d.csv --
t,P
0,1
-- app.ss --
[options]
delta_t 10
[data]      #! E0773 a state of the machine
file "d.csv"
time "t" ms
x = "P"
[all_states]
true: @stop
