spec 8.57  Numbers with and without point, exponent and sign; true and false.

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
t,P,Q,B,N
0, +1.50 ,-.5,TRUE,7.
10,1e2,5E-1,false,2
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
y = "Q"
b = "B"
n = "N"
[all_states]
G == 0: @assert x == 1.5 and y == -0.5 and b and n == 7
G == 10: @assert x == 100 and y == 0.5 and not b and n == 2
G == 10: @stop
