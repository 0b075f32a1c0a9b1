spec 1.23   There are no lists of values, and no arrays.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
F64 x[3]                #! E0336 as F64 x1 and F64 x2
[local]
bool bad[5]             #! E0336 as bool bad1 and bool bad2
I32 y[2] = {1, 2}       #! E0336 as I32 y1
F64 z[] = [1, 2]        #! E0336 as F64 z1
F64 yy[2][3] = 0        #! E0336 as F64 yy1
[Hold]
.step
    bad[1]: v = 1       #! E0336 write bad1
    v = x[v]            #! E0336 choose between them
    v = x[v + 1]        #! E0336 choose between them
    v = yy[1][2]        #! E0336 choose between them
