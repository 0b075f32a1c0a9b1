# What the application of stand.app shares.
[Time]
U64  time
U16  ticks

[Stand]
I16  reading
F64  pressure
F64  low
F32  gain
I8   trim
I16  offset
U8   mode
U8   valve
bool armed
bool open
U32  slowly
I64  total

[States]
U32  ventState
U32  watchState
