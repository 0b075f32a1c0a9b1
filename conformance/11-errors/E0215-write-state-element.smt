spec 5.5   S cannot be assigned, neither under that name nor under the element's own.
-- app.sm --
[state_vector]
U64 G
U32 state @alias S
[Hold]
.step
    S = 1             #! E0215 number of the state
    state = 1         #! E0215 write -> Hold
    S = 2             #! E0215
