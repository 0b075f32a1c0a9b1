spec 9.5  The element of a digital pin is a bool, that of an analog pin has any other type.

-- app.sv --
[R]
I8 a I16 b I32 c I64 d U8 e U16 f U32 g U64 h F32 i F64 j bool k
-- app.io --
[analog]
i 0 a
i 1 b
i 2 c
i 3 d
i 4 e
i 5 f
o 6 g
o 7 h
o 8 i
o 9 j
[digital]
i 0 k
o 1 k
