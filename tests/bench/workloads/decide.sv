# The inputs first.

[In]
U64   time
F64   chamber
F32   lox
F32   fuel
F32   flow
I32   thrust
U16   bus
U16   speed
I16   vibe
I16   temp
U8    mode
U8    command
bool  armed
bool  hot
bool  cold
bool  wet

[Out]
U32   state
F32   valve
I16   trim
U16   code
U8    level
U8    warnings
I8    vote
bool  open
bool  spark
bool  alarm
