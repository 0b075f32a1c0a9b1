passes simplify_cfg,dce
# Empty arms: the branch is removed, and then the condition, which has no other use.

-- ir --
state A
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    jmp b3
b2:
    jmp b3
b3:
    ret
}
exit {
b0:
    jmp b2
b1:
    %0 = const U8 1
    store U8 u8, %0
    jmp b2
b2:
    ret
}
-- ir out --
state A
step {
b0:
    ret
}
exit {
b0:
    ret
}
