[Time]
U64  time

[Stand]
F64  pressure
F64  average
U32  count
U32  valveState
