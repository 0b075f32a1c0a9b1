spec 8.66  The first step that is compared is that with G = d.
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
0,1
10,0
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
@compare out "CMD" delay 20 ms   #! E0781 'out' differs from column 'CMD' in 1 of 4 steps
[all_states]
G == 50: @stop
