spec 5.9   A declaration among statements becomes one in [local], and an assignment where it was.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 code
[Hold]
.entry
    U32 count = 0           #! E0338 write 'U32 count = 0' in [local], and 'count = 0' here
    int n = code + 1        #! E0338 write 'I32 n = 0' in [local], and 'n = code + 1' here
    const F64 k = 3         #! E0338 write 'F64 k = 3 @read_only' in [local]
    F32 z                   #! E0338 write 'F32 z = 0' in [local]
    code > 5: U8 m = 1      #! E0338 write 'U8 m = 1' in [local], and 'm = 1' here
