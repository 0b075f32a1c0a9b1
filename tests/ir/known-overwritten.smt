passes known,dce
# A store to a variable that no later block loads ends what an earlier store said about it.  So a comparison of the value stored last has both
# edges, and u8 has two values where they meet.

-- ir --
state A
step {
b0:
    %0 = const F64 0
    store F64 x, %0
    %1 = load bool flag
    br %1, b1, b2
b1:
    %2 = const F64 0
    store F64 x, %2
    jmp b2
b2:
    %3 = load F64 y
    store F64 x, %3
    %4 = const F64 5
    %5 = gt F64 %3, %4
    br %5, b3, b4
b3:
    %6 = const U8 1
    store U8 u8, %6
    jmp b5
b4:
    %7 = const U8 2
    store U8 u8, %7
    jmp b5
b5:
    %8 = load U8 u8
    %9 = cvt U16 %8
    store U16 u16, %9
    ret
}
-- ir out --
state A
step {
b0:
    %0 = const F64 0
    store F64 x, %0
    %1 = load bool flag
    br %1, b1, b2
b1:
    %2 = const F64 0
    store F64 x, %2
    jmp b2
b2:
    %3 = load F64 y
    store F64 x, %3
    %4 = const F64 5
    %5 = gt F64 %3, %4
    br %5, b3, b4
b3:
    %6 = const U8 1
    store U8 u8, %6
    jmp b5
b4:
    %7 = const U8 2
    store U8 u8, %7
    jmp b5
b5:
    %8 = load U8 u8
    %9 = cvt U16 %8
    store U16 u16, %9
    ret
}
