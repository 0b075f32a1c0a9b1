spec 5.7  The same in .entry, in .exit and within conditionals.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only

[Run]
.entry
    x = 1   #! E0212
.step
    if T > 5 {
        T > 6: x = 2   #! E0212
    }
.exit
    x = 3   #! E0212
