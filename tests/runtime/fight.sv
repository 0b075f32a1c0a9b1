# What threads fight for.
[options]
lock

[Pair]
U64  a
bool odd
U64  not_a
F64  number

[Many]
U64  m0
U64  m1
U64  m2
U64  m3
U64  m4
U64  m5
U64  m6
U64  m7

[Count]
U64  hits
U32  writes
