spec 5.47   A dash between the numbers of a range is no sign of the second one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @range 0 – 5      #! E0102 separate two numbers by a space
F64 b @range 0 5
[Hold]
.step
    b = a – 1           #! E0102 write -
    b = 0·5             #! E0102 decimal point is written .
