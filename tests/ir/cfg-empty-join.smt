passes simplify_cfg
# The empty block in which the inner conditional ends is passed over; both stay nested.

-- ir --
state A
step {
b0:
    %0 = load bool a
    br %0, b1, b4
b1:
    %1 = load bool b
    br %1, b2, b3
b2:
    %2 = const U8 1
    store U8 u8, %2
    jmp b3
b3:
    jmp b5
b4:
    jmp b5
b5:
    %3 = const U8 2
    store U8 u8, %3
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load bool a
    br %0, b1, b3
b1:
    %1 = load bool b
    br %1, b2, b3
b2:
    %2 = const U8 1
    store U8 u8, %2
    jmp b3
b3:
    %3 = const U8 2
    store U8 u8, %3
    ret
}
