spec 8.68  delta_t file makes one step of each row, at its time.

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
100,1
107,2
112,3
112.4,4
150,5
-- app.ss --
[options]
delta_t file
[data]
file "d.csv"
time "t" ms   #! W0770 1 of 5 rows
x = "P"
[all_states]
G == 0: @assert x == 1
G == 7: @assert x == 2
G == 12: @assert x == 3
G == 50: @assert x == 5
G >= 50: @stop
