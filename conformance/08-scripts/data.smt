spec 8.54  Columns of a file are written to variables.

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
10,2.5
30,4
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 0: @assert x == 1 and seen == 1
G == 10: @assert x == 2.5
G == 20: @assert x == 2.5
G == 30: @assert x == 4
G == 50 { @assert x == 4
  @stop }
