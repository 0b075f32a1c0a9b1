spec 8.68  With delta_t file, @expect counts the times of the rows.
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
t,P
0,1
7,2
30,3
90,4
-- app.ss --
[options]
delta_t file
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 0: @expect x == 3 within 30
G == 7: @expect x == 4 within 60   #! E0756 expected within 60 after G = 7
G >= 90: @stop
