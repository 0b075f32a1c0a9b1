# The state vector of the application that the test builds.
[Time]
U64  time

[Probe]
F64  pressure
U8   mode
I16  offset
bool armed
F32  gain
U32  probeState
U32  late
U16  ticks
