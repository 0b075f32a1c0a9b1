spec 5.47   A range that exceeds the range of the type.

-- app.sm --
[state_vector]
U64 G
U32 S
U8  a @range 0 300        #! W0211 the range of 'a' extends to 300, but U8 ends at 255
I8  b @range -129 128     #! W0211 the range of 'b' extends to -129, but I8 ends at -128
U16 c @range -1 4000      #! W0211 the range of 'c' extends to -1, but U16 ends at 0
U8  d @range 0 255
I8  e @range -128.5 127.5
F32 f @range -1e39 1e39
U64 g @range 0 1e18
F64 y
[A]
.step
    y = a + b + c + d + e + f + g
