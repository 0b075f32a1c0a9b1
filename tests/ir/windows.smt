passes windows
# Only w1 uses w0, and w1 is unused; of w2 only one statistic is used.

-- ir --
window w0 F64 size 3 stats avg
window w1 F64 size 4 stats avg
window w2 F64 size 5 stats min max
window w3 F64 size 6 stats median
window w4 F64 size 7 stats range
sample {
b0:
    %0 = load F64 x
    sample w0, %0
    %1 = stat avg w0
    sample w1, %1
    %2 = load F64 y
    sample w2, %2
    %3 = stat max w2
    %4 = load F64 x
    sample w3, %4
    %5 = stat median w3
    sample w4, %5
    ret
}
state A
step {
b0:
    %0 = stat min w2
    %1 = cvt F64 %0
    store F64 x, %1
    ret
}
exit {
b0:
    %0 = stat range w4
    %1 = cvt F64 %0
    store F64 x, %1
    ret
}
-- ir out --
window w0 F64 size 5 stats min
window w1 F64 size 6 stats median
window w2 F64 size 7 stats range

sample {
b0:
    %0 = load F64 y
    sample w0, %0
    %1 = load F64 x
    sample w1, %1
    %2 = stat median w1
    sample w2, %2
    ret
}

state A
step {
b0:
    %0 = stat min w0
    %1 = cvt F64 %0
    store F64 x, %1
    ret
}
exit {
b0:
    %0 = stat range w2
    %1 = cvt F64 %0
    store F64 x, %1
    ret
}
