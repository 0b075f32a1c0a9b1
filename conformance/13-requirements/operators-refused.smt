spec 13.6, 13.7, 13.12  Implications do not chain, and never has none.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
F64 q @read_only
bool on

[define]
high = p > 10

[A]
.step
    on = false
    p == 1: -> B
    p == 2: -> C

[B]
.step
    on = true
    p == 0: -> A
    p == 2: -> C

[C]
.step
    on = true
    p == 0: -> A
    p == 1 and not high: -> B

-- app.rq --
R1 "a"  always p > 1 implies q > 1 implies on        #! E1305 write p > 1 and q > 1 implies
R2 "b"  never  p > 1 implies on                      #! E1306
R3 "c"  always p > 1 leads to on                     #! E1303 expected 'within'
R4 "d"  always p > 1 leads on within 10 ms           #! E1303 expected 'to'
R5 "e"  never A after B                              #! E1303 expected 'without'
R6 "f"  always p > 1 or (q > 2 implies on) implies on
