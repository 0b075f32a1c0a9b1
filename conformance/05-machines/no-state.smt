spec 5.24  A machine without a state is an error.

-- app.sm --
[state_vector]   #! E0503
U64 G
U32 S
F64 x
