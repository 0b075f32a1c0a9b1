passes locals,dce
# A parameter is no constant, although nothing stores to it; another local is one.

-- ir --
machine "m"
vector "m" size 64 hash 0
element U64 G at 0 is G
element U32 S at 8 is S
element F64 y writable at 16
local F32 gain parameter 0xbff8000000000000 1 default 0x3dcccccd = 0x3f000000
local U8 n parameter 1 9 default 3 = 4
local U8 k = 4
time U64 T

state A
step {
b0:
    %0 = load U8 n
    %1 = load U8 k
    %2 = cvt F64 %0
    %3 = cvt F64 %1
    %4 = add F64 %2, %3
    store F64 y, %4
    ret
}
-- ir out --
machine "m"
vector "m" size 64 hash 0x00000000

element U64 G at 0 is G
element U32 S at 8 is S
element F64 y writable at 16
local F32 gain parameter 0xbff8000000000000 1 default 0x3dcccccd = 0x3f000000  # 0.5
local U8 n parameter 1 9 default 3 = 4
local U8 k = 4
time U64 T

state A
step {
b0:
    %0 = load U8 n
    %1 = const U8 4
    %2 = cvt F64 %0
    %3 = cvt F64 %1
    %4 = add F64 %2, %3
    store F64 y, %4
    ret
}
