spec 1.21   Errors about what is declared elsewhere tell what to change.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
bool valve
[local]
F64 limit = 800 @read_only
[Fill]
.step
    limit = 900                     #! E0213 remove @read_only from its declaration
    pressure = 1                    #! E0212 store what is computed in another variable
    pressure > limit {              #! E0321 write '}' below the last statement
        valve = true
[Hold]
[Hold]                              #! E0502 give it another name
