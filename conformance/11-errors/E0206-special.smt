spec 5.2, 5.5   Where the state vector has G or S of another type, it is the state vector that is wrong.
-- app.sv --
[Main]
U32 time
U8  state
F32 p
-- app.sm --
[state_vector]
U64 time  @alias G    #! E0206 it must be U64: change the state vector file
U32 state @alias S    #! E0206 it must be U32: change the state vector file
F32 p
[Hold]
.step
    p > 5: p = 0
