passes fold,dce
# One operand decides an `and` or an `or`; what the other one is does not matter.

-- ir --
state A
step {
b0:
    %a = load bool a
    %f = const bool 0
    %t = const bool 1
    %0 = and %a, %f
    store bool flag, %0
    %1 = or %t, %a
    store bool flag, %1
    %2 = and %t, %a
    store bool flag, %2
    %3 = or %a, %f
    store bool flag, %3
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load bool a
    %1 = const bool 0
    %2 = const bool 1
    %3 = const bool 0
    store bool flag, %3
    %4 = const bool 1
    store bool flag, %4
    %5 = and %2, %0
    store bool flag, %5
    %6 = or %0, %1
    store bool flag, %6
    ret
}
