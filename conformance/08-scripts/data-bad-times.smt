spec 8.59  Rows without a later time are skipped, whatever else they contain.

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
,9
5,1
5,a
15,2
10,b
nan,8
25,3
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms    #! W0770 4 of 7 rows are skipped, because their time is missing or not later than in the row before; the first is d.csv:2
x = "P"
[all_states]
G == 0: @assert x == 1
G == 10: @assert x == 2
G == 20: @assert x == 3
G == 20: @stop
