spec 8.66  @compare compares after the step, within a tolerance and with a delay.

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
t,B,OUT,P
0,0,0,1
10,1,0,2
20,1,1,3.5
30,0,1,4
40,0,0,4
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
b = "B"
x = "P"
@compare out "B"
@compare x "P" tolerance 1.5 delay 10 ms
@compare seen "P"
[all_states]
G == 60: @stop
