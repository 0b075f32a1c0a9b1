# What two machines and a thread share, all at once.

[options]
lock

[Clock]
U64  now

[Writer]
F64  left               # written in one go with right, always the same
U32  right
U32  mine               # written by the thread alone, though a machine could

[First]
U32  firstState
U8   firstLow           # these two are stored in one step, always the same
U64  firstHigh
U32  firstTorn

[Second]
U32  secondState
U16  secondLow
F32  secondHigh
U32  secondTorn
