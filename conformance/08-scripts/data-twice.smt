spec 8.54  A script has one section [data], with its included files.
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
-- a.ss --
[data]
file "d.csv"
time "t" ms
x = "P"
-- app.ss --
include "a.ss"
[options]
delta_t 10
[data]      #! E0775 one section
file "d.csv"
time "t" ms
y = "P"
[all_states]
true: @stop
