passes identity,dce
# and, or with the value that decides nothing, or twice with the same; not not.  The branch names what is left.

-- ir --
state A
step {
b0:
    %t = const bool 1
    %f = const bool 0
    %a = load bool a
    %0 = and %a, %t
    %1 = or %f, %0
    %2 = not %1
    %3 = not %2
    %4 = and %3, %3
    br %4, b1, b2
b1:
    %b = load bool b
    %5 = and %b, %b
    %6 = not %5
    store bool flag, %6
    ret
b2:
    %7 = load bool b
    %c = load bool c
    %8 = or %7, %c
    store bool flag, %8
    ret
}
-- ir out --
state A
step {
b0:
    %0 = load bool a
    br %0, b1, b2
b1:
    %1 = load bool b
    %2 = not %1
    store bool flag, %2
    ret
b2:
    %3 = load bool b
    %4 = load bool c
    %5 = or %3, %4
    store bool flag, %5
    ret
}
