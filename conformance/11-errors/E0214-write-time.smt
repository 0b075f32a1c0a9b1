spec 5.5   G cannot be assigned, neither under that name nor under the element's own.
-- app.sm --
[state_vector]
U64 time @alias G
U32 S
[Hold]
.step
    G = 1             #! E0214 the time
    time = 1          #! E0214 the time
