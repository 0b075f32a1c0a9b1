# The inputs first.

[In]
U64   time
F64   rate        # -1 ... 1
U16   level       # 0 ... 99
bool  ready

[Out]
U32   state
F64   total
I32   sum
U16   marks
U8    run
bool  open
