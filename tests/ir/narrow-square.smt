passes narrow,dce
# A value times itself is never -0, so an integer's goes to a float, too.
# Times another it may be -0.

-- ir --
state A
step {
b0:
    %0 = load I16 i16
    %1 = cvt F64 %0
    %2 = mul F64 %1, %1
    store F64 x, %2
    %3 = load U8 u8
    %4 = cvt F64 %3
    %5 = mul F64 %1, %4
    store F64 y, %5
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load I16 i16
    %1 = cvt F64 %0
    %2 = cvt I32 %0
    %3 = mul I32 %2, %2
    %4 = cvt F64 %3
    store F64 x, %4
    %5 = load U8 u8
    %6 = cvt F64 %5
    %7 = mul F64 %1, %6
    store F64 y, %7
    ret
}
