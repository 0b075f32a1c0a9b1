spec 1.3, 1.1  A byte-order mark anywhere but at the start is a character like any other that is not ASCII.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = ﻿1   #! E0102
