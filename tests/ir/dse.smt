passes dse,dce
# A store is dropped when the same block overwrites the variable before it is read; an unused load does not count as a read.

-- ir --
state A
step {
b0:
    %0 = const U8 1
    %1 = const U8 2
    %2 = load U8 u8
    store U8 u8, %0
    %3 = load U8 u8
    store U8 u8, %1
    %4 = load U8 u8
    store U8 u8, %2
    %5 = cvt U16 %4
    store U16 u16, %5
    %6 = load bool a
    br %6, b1, b2
b1:
    %7 = const U16 3
    store U16 u16, %7
    %8 = const U16 4
    store U16 u16, %8
    ret
b2:
    %9 = const U16 5
    store U16 u16, %9
    ret
}
-- ir out --
state A
step {
b0:
    %0 = const U8 2
    %1 = load U8 u8
    store U8 u8, %0
    %2 = load U8 u8
    store U8 u8, %1
    %3 = cvt U16 %2
    store U16 u16, %3
    %4 = load bool a
    br %4, b1, b2
b1:
    %5 = const U16 4
    store U16 u16, %5
    ret
b2:
    %6 = const U16 5
    store U16 u16, %6
    ret
}
