spec 5.78  A parameter needs a range, unless it is a bool; other locals have none.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 a = 1 @parameter              #! E0418 parameter 'a' has no range
bool b = 1 @parameter
bool c = 1 @parameter @range 0 1  #! E0222 'c' is a bool and cannot have a range
F64 d = 1 @range 0 2              #! E0362 '@range' is allowed only on elements of the state vector and parameters
F64 e = 1 @parameter @range 2 0   #! E0220 the range of 'e' is empty
F64 f @parameter @range 0 2       #! E0355 local 'f' needs an initial value
F64 g = 1 @parameter @range 1 1
[Run]
.step
    x = a + b + c + d + e + g
