spec 8.55  A relative name of a file starts at the folder of the script that contains it.

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
-- sub/d.csv --
t,P
0,7
-- sub/plant.ss --
[data]
file "d.csv"
time "t" ms
x = "P"
-- app.ss --
include "sub/plant.ss"
[options]
delta_t 10
[all_states]
G == 0: @assert x == 7
G == 0: @stop
