spec 13.3, 13.6  A variable with the name of a function can precede a word.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool abs
[A]
.step
    abs = p == 1

-- app.rq --
R1 "a"  always abs implies p == 1
R2 "b"  always p == 1 leads to abs within 10
R3 "c"  always abs leads to p < 9 within 10

-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 0
G == 10: p = 1
G == 20: p = 0
G == 20: @stop
