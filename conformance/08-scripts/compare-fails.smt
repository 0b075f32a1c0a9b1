spec 8.67  A @compare that is not met does not end the script, and makes it fail.
expect fail

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
20,1
40,0
60,1
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
@compare out "CMD"   #! E0781 'out' differs from column 'CMD' in 5 of 9 steps
[all_states]
G == 80: @stop
