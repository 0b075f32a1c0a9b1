[Time]
U64  time

[Bench]
U32  n
bool armed
U32  countState
U32  otherState
