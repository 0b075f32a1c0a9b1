spec 8.70  A file without a header is an error.
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
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"     #! E0779 the file is empty
time "t" ms
x = "P"
[all_states]
true: @stop
