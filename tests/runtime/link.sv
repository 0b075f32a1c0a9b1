[options]
lock
[Tank]
F64  pressure   @range -10 1000
F32  flow
bool open
I8   tiny       @range -5 5
I64  wide
U16  level
[Commands]
bool vent
F32  throttle
I16  trim
F64  target
U64  total
[Sealed]
bool lit
U32  run
[State]
U16  age
U8   accepted
U32  refused
U32  shorts
U32  longs
U32  damaged
U32  hashes
U32  keys
U32  repeated
U32  late
U32  nans
U32  ranges
U32  sent
U32  lost
