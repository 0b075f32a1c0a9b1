# Every type beside every other size, so that each needs its own place.
[Small]
bool first
I64  second
U8   third
U16  fourth
I8   fifth
U32  sixth
bool seventh

[One]
U8   only

[Reals]
F32  real32
F64  real64
I16  last

[Clock]
U32  mode
U64  time
I32  end
bool flag
