passes cse,dce
# What is only stored or branched on is computed where it is: a temporary would be a copy more.  Statistics cost more than that.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element F64 x writable at 24
element F64 y writable at 32
element F64 z writable at 40
element bool p writable at 48
time U64 T
window w0 F64 size 5 stats avg

sample {
b0:
    %0 = load F64 x
    sample w0, %0
    ret
}
state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = add F64 %0, %1
    %3 = cvt F64 %2
    store F64 z, %3
    %4 = add F64 %0, %1
    %5 = cvt F64 %4
    store F64 x, %5
    %6 = stat avg w0
    %7 = cvt F64 %6
    store F64 y, %7
    %8 = stat avg w0
    %9 = lt F64 %0, %8
    store bool p, %9
    %10 = lt F64 %0, %8
    br %10, b1, b2
b1:
    goto A
b2:
    ret
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element F64 x writable at 24
element F64 y writable at 32
element F64 z writable at 40
element bool p writable at 48
time U64 T
window w0 F64 size 5 stats avg

sample {
b0:
    %0 = load F64 x
    sample w0, %0
    ret
}

state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = add F64 %0, %1
    %3 = cvt F64 %2
    store F64 z, %3
    %4 = add F64 %0, %1
    %5 = cvt F64 %4
    store F64 x, %5
    %6 = stat avg w0
    %7 = cvt F64 %6
    store F64 y, %7
    %8 = lt F64 %0, %6
    store bool p, %8
    %9 = lt F64 %0, %6
    br %9, b1, b2
b1:
    goto A
b2:
    ret
}
