passes dce
# A whole unused expression is removed in one walk; stores and their operands stay.

-- ir --
window w0 F64 size 3 stats avg
sample {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = mul F64 %0, %1
    sample w0, %0
    ret
}
state A
step {
b0:
    %0 = load F64 x
    %1 = load F64 y
    %2 = add F64 %0, %1
    %3 = mul F64 %2, %2
    %4 = stat avg w0
    %5 = sqrt F64 %4
    %6 = gt F64 %3, %5
    %7 = sub F64 %0, %4
    %8 = cvt F64 %7
    store F64 y, %8
    ret
}
-- ir out --
window w0 F64 size 3 stats avg

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
    %1 = stat avg w0
    %2 = sub F64 %0, %1
    %3 = cvt F64 %2
    store F64 y, %3
    ret
}
