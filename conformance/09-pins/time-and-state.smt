spec 9.13  G and S of a machine are nobody's inputs; they may be outputs.

-- app.sv --
[R]
U64 clock
U32 S
F64 pressure
F64 limit
F64 other
bool open
-- app.sm --
[state_vector]
U64 clock @alias G
U32 S
F64 pressure
F64 limit
bool open
[Hold]
.step
    pressure > limit: open = true
    limit = pressure / 2
-- app.io --
[analog]
i 0 clock        #! E1187 'clock' is the time, G, of machine 'app'
i 1 S            #! E1188 'S' is the state, S, of machine 'app'
o 2 clock
o 3 S
