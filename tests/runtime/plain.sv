# As wide.sv, for one thread.
[options]


[Clock]
U64  time
U32  state

[All]
I8   i8
I64  i64
bool flag
I16  i16
U8   u8
I32  i32
U16  u16
U64  u64
F32  f32
U32  u32
F64  f64

[Names]
U8   class
U8   vector
U8   set_class
F64  __proto
bool app
