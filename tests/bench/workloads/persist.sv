# Pressures, temperature, current and buttons first.

[In]
U64   time        # ms
F32   p0          # bar
F32   p1
F32   p2
F32   p3
F32   heat        # degrees C
I16   current     # mA
bool  armed
bool  key
bool  link

[Out]
U32   state
F32   slope       # bar/s
F32   drift       # degrees C/s
I16   trend
U16   presses
U8    score
I8    balance
U8    lost
U8    tries
U16   done
bool  valve
bool  vent
bool  alarm
bool  horn
