spec 8.66  Where the column has no value, nothing is compared.

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
t,CMD,P
0,,1
20,0,nan
40,,3
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
missing nan
x = "P"
b = "CMD"
@compare out "CMD"
@compare seen "P"
[all_states]
G == 80: @stop
