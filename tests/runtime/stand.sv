# A test stand: what the machines of these tests read and write, and some elements that are nobody's business of theirs.

[options]
lock

[Before]
U32  foreign

[Time]
U64  clock

[Orders]
I16  order
F64  pressure
U32  left               # written in one go with right, always the same
U32  right

[Results]
U32  testerState
bool valve
I8   fin
U16  level
F32  flow
F64  sum
U32  torn               # how often left and right differed

[Behind]
U64  stranger
