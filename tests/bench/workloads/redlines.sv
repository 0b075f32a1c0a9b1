# The sensors first.

[In]
U64   time        # ms
F32   s0
F32   s1
F32   s2
F32   s3
F32   s4
F32   s5
F32   s6
F32   s7
F32   s8
F32   s9
F32   s10
F32   s11
F32   s12
F32   s13
F32   s14
F32   s15
F32   s16
F32   s17
F32   s18
F32   s19
F32   s20
F32   s21
F32   s22
F32   s23
bool  reset

[Out]
U32   state
F32   hottest
U16   trips
U8    code
bool  closed
