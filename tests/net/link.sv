[Data]
U32  n
U64  square        # n * n: a message that is torn or damaged would show it
F64  half          # n / 2
bool odd
[State]
U32  age
U32  accepted
U32  refused
U32  damaged
U32  repeated
U32  late
U32  shorts
U32  longs
U32  sent
U32  hashes
U32  connected
U32  broken
