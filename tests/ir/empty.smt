passes simplify_cfg,dce,empty
# Conditionals that do nothing leave a function that does nothing; one that only makes a transition stays.

-- ir --
state A
entry {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    jmp b2
b2:
    ret
}
step {
b0:
    %0 = load bool a
    goto B
}
exit {
b0:
    %0 = load bool a
    ret
}
state B
-- ir out --
state A
step {
b0:
    goto B
}

state B
