spec 1.25   A declared element may be called like a label: as a condition it is no label without its point.

-- app.sm --
[state_vector]
U64 G
U32 S
bool entry @read_only
bool lamp
[Hold]
.step
    entry:              #! E0316 write '{'
        lamp = true
