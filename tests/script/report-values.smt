# Every type as the report shows it: F32 and F64 as %f, integers as integers, bool as a word.

-- app.sm --
[state_vector]
U64 G
U32 S
I8 i8
I16 i16
I32 i32
I64 i64
U8 u8
U16 u16
U32 u32
U64 u64
F32 f32
F64 f64
F64 big
F64 inf
F64 minusInf
F64 minusZero
F64 half
F32 tenth
bool b
[local]
I64 lowest = -9223372036854775808
F64 notANumber = 0/0
[Only]
.step
    i8 = -1000
    i16 = -1000
    i32 = -1
    i64 = -1
    u8 = 1000
    u16 = 65535
    u32 = 1e10
    u64 = 1e30
    f32 = 16777217
    f64 = 1/3
    big = 1e22
    inf = 1/0
    minusInf = -1/0
    minusZero = -0.0
    half = 0.0000005
    tenth = 0.1
    b = 0.25
-- app.ss --
[options]
delta_t 1
[all_states]
true: @stop
-- report --
state script ran for 1 step
0 asserts passed
final state vector:
  G = 0
  S = 1
  T = 0
  b = true
  big = 10000000000000000000000.000000
  f32 = 16777216.000000
  f64 = 0.333333
  half = 0.000000
  i16 = -1000
  i32 = -1
  i64 = -1
  i8 = -128
  inf = inf
  lowest = -9223372036854775808
  minusInf = -inf
  minusZero = -0.000000
  notANumber = 0.000000
  tenth = 0.100000
  u16 = 65535
  u32 = 4294967295
  u64 = 18446744073709551615
  u8 = 255
