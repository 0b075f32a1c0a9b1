spec 13.12, 8.68  The rows of recorded data are the steps: the last row that is in time decides, although the next one is much later.
expect fail

-- app.sm --
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
F64 q @read_only
bool on

[A] @safe
.step
    on = p > q
-- app.rq --
R1 "q follows p" always p == 1 leads to q == 1 within 20      #! E1310 in step 3
R2 "in time"     always p == 1 leads to q == 1 within 60      #! W1301
-- flight.csv --
t,p,q
0,0,0
5,1,0
20,0,0
60,0,1
-- app.ss --
[options]
delta_t file
[data]
file "flight.csv"
time "t" ms
p = "p"
q = "q"
[all_states]
at 20: @stop
