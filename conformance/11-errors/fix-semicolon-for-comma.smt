spec 4.2   Arguments are separated by commas; the edit writes one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = max(x; 1)   #! E0107
