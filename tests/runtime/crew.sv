# For tests of tasks, executors and applications: G, modes, a vital of every integer type.
[options]
lock

[Clock]
U64  time

[Modes]
U8   first
U8   second
U8   third

[Vitals]
I8   v_i8
I16  v_i16
I32  v_i32
I64  v_i64
U8   v_u8
U16  v_u16
U32  v_u32
U64  v_u64

[Other]
F64  number
bool flag
