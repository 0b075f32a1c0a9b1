[options]
lock
[Report]
F64  pressure
I64  wide2
bool open
[Beacon]
U16  level
[Orders]
F32  throttle
I16  trim
U64  wide
[Secret]
bool lit
U32  run
[State]
U32  age
U32  accepted
U32  refused
U32  shorts
U32  damaged
U32  hashes
U32  repeated
U32  late
U32  nans
U32  begun
U32  broken
U32  keys
U32  secretBroken
U32  reportSent
U32  reportLost
U32  reportFull
U32  reportApart
U32  reportBegun
U32  reportBroken
U32  beaconSent
U32  beaconApart
