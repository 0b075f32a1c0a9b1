# The sensors first, then what is made of them.

[In]
U64   time
F32   accX        # m/s2
F32   accY
F32   accZ
F32   gyroX       # rad/s
F32   gyroY
F32   baro        # m
F32   command

[Out]
U32   state
F32   smoothX
F32   smoothY
F32   smoothZ
F32   notchX
F32   notchY
F32   pitch
F32   roll
F32   height
F32   climb
F32   slewed
F32   error
F32   integral
F32   output
F32   energy
F32   peak
F32   washed
F32   band
F32   lead
bool  moving
bool  saturated
