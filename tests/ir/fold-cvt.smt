passes fold
# Conversions saturate, truncate toward zero, and make NaN 0 or false.

-- ir --
state A
step {
b0:
    %big = const F64 300
    %minus = const F64 0xbfe0000000000000
    %nan = const F64 0x7ff8000000000000
    %inf = const F64 0x7ff0000000000000
    %tiny = const F64 0x0000000000000001
    %0 = cvt U8 %big
    %1 = cvt I8 %big
    %2 = cvt I16 %minus
    %3 = cvt U64 %inf
    %4 = cvt I64 %inf
    %5 = cvt I32 %nan
    %6 = cvt F32 %nan
    %7 = cvt F64 %nan
    %8 = cvt bool %nan
    %9 = cvt bool %tiny
    %10 = cvt F32 %tiny
    %11 = cvt F32 %inf
    %12 = cvt F64 %minus
    %i8 = const I8 -1
    %13 = cvt F64 %i8
    %i64 = const I64 9223372036854775807
    %14 = cvt F64 %i64
    %u64 = const U64 18446744073709551615
    %15 = cvt F64 %u64
    %bool = const bool 1
    %16 = cvt F64 %bool
    %f32 = const F32 0x3dcccccd
    %17 = cvt F64 %f32
    ret
}
-- ir out --
state A
step {
b0:
    %0 = const F64 300
    %1 = const F64 0xbfe0000000000000  # -0.5
    %2 = const F64 0x7ff8000000000000  # nan
    %3 = const F64 0x7ff0000000000000  # inf
    %4 = const F64 0x0000000000000001  # 4.94065645841247e-324
    %5 = const U8 255
    %6 = const I8 127
    %7 = const I16 0
    %8 = const U64 18446744073709551615
    %9 = const I64 9223372036854775807
    %10 = const I32 0
    %11 = const F32 0
    %12 = const F64 0
    %13 = const bool 0
    %14 = const bool 1
    %15 = const F32 0
    %16 = const F32 0x7f800000  # inf
    %17 = const F64 0xbfe0000000000000  # -0.5
    %18 = const I8 -1
    %19 = const F64 -1
    %20 = const I64 9223372036854775807
    %21 = const F64 0x43e0000000000000  # 9.223372036854776e+18
    %22 = const U64 18446744073709551615
    %23 = const F64 0x43f0000000000000  # 1.8446744073709552e+19
    %24 = const bool 1
    %25 = const F64 1
    %26 = const F32 0x3dcccccd  # 0.1
    %27 = const F64 0x3fb99999a0000000  # 0.10000000149011612
    ret
}
