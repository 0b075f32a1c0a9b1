spec 8.55  [data] has a file, a time, and a column.
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
[data]      #! E0774 no column of times
file "d.csv"
x = "P"
[all_states]
true: @stop
