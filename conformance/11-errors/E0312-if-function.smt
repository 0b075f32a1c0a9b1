spec 5.4   There is no function IF: a choice is a statement. One message, whatever separates its arguments.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    x = IF(p > 5; 1; 0)       #! E0312 write it as if
    x = If(p > 5, 1, 0)       #! E0312
    x = 2 * if(p > 5; 1; 0)   #! E0312
    on = false
