spec 5.15   An element is listed once.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
F64 pressure             #! E0202 'pressure' is declared here
[Hold]
.step
    pressure = 1
