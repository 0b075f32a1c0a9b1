passes simplify_cfg
# A branch on a known condition becomes a jump, the unreachable arm is removed, and the rest is one block.

-- ir --
state A
step {
b0:
    %0 = const bool 1
    br %0, b1, b2
b1:
    %1 = const U8 1
    store U8 u8, %1
    jmp b3
b2:
    %2 = const U8 2
    store U8 u8, %2
    jmp b3
b3:
    %3 = const bool 0
    br %3, b4, b5
b4:
    goto B
b5:
    %4 = const U8 3
    store U8 u8, %4
    ret
}
state B
-- ir out --
state A
step {
b0:
    %0 = const bool 1
    %1 = const U8 1
    store U8 u8, %1
    %2 = const bool 0
    %3 = const U8 3
    store U8 u8, %3
    ret
}

state B
