# The sensors first.

[In]
U64   time        # ms
F32   p1          # bar
F32   p2
F32   p3
F32   a1          # m
F32   a2
I16   t1          # 0.1 degrees C
I16   t2
bool  reset

[Out]
U32   state
F32   voted       # bar
F32   slow
F32   spread
F32   altitude    # m
F32   band
F32   doubt
F32   warm        # 0.1 degrees C
I16   jump
U16   bad1        # steps
U16   bad2
U16   bad3
U8    healthy
bool  stuck
bool  split
