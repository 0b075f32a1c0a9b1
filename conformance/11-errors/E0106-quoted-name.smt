spec 1.10   Names are written without quotation marks.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q
U8 code
[Idle]
.step
    “p” > 5: code = 1                #! E0106 write p
    'p' > 5: code = 2               #! E0106 write p
    code = "vent"                   #! E0106 write vent if it is a name
    q = “p”                         #! E0106 write p
    p > "60": -> Abort              #! E0106 names and conditions
[Abort]
