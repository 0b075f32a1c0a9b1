spec 8.67  A @compare that is never evaluated is reported.

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
t,CMD
0,0
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
@compare out "CMD" delay 1 s   #! W0771
[all_states]
G == 80: @assert not out
G == 80: @stop
