spec 5.7   An element marked @read_only cannot be assigned, under no name.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
F64 flow @alias q @read_only
[Hold]
.step
    pressure = 1      #! E0212 'pressure' is declared here
    flow = 1          #! E0212
    G > 5 {
        q = 1         #! E0212
    }
