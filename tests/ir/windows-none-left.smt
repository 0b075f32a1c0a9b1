passes windows
# Without a window there is no sample function.

-- ir --
window w0 F64 size 3 stats avg
sample {
b0:
    %0 = load F64 x
    sample w0, %0
    ret
}
state A
-- ir out --
state A
