# An else-if chain has one join block.  Statements after a transition and unreachable blocks are not built.

-- ifs.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool y @read_only
[local]
I32 n = 0
[A]
.entry
    x > 10 and y: -> B
.step
    if x > 3 {
        if x > 5 {
            n = n + 1
            if x > 7: -> B
            else: n = n + 2
            n = n + 3
        }
    }
    else if x > 2: n = 4
    else if y: -> C
    else { n = 5 }
    n = n * 2
[B]
.step
    if y: -> C
    else: -> A
    n = 1
[C]
.step
    y { -> A
        n = 2 }
    -> B
-- ir out --
machine "ifs"
vector "ifs" size 32 hash 0xd2e2bb77

element U64 G at 0 is G
element U32 S at 8 is S
element F64 x at 16
element bool y at 24
local I32 n writable = 0
time U64 T

state A
entry {
b0:
    %0 = load F64 x
    %1 = const F64 10
    %2 = gt F64 %0, %1
    %3 = load bool y
    %4 = and %2, %3
    br %4, b1, b2
b1:
    goto B
b2:
    ret
}
step {
b0:
    %0 = load F64 x
    %1 = const F64 3
    %2 = gt F64 %0, %1
    br %2, b1, b7
b1:
    %3 = load F64 x
    %4 = const F64 5
    %5 = gt F64 %3, %4
    br %5, b2, b6
b2:
    %6 = load I32 n
    %7 = cvt F64 %6
    %8 = const F64 1
    %9 = add F64 %7, %8
    %10 = cvt I32 %9
    store I32 n, %10
    %11 = load F64 x
    %12 = const F64 7
    %13 = gt F64 %11, %12
    br %13, b3, b4
b3:
    goto B
b4:
    %14 = load I32 n
    %15 = cvt F64 %14
    %16 = const F64 2
    %17 = add F64 %15, %16
    %18 = cvt I32 %17
    store I32 n, %18
    jmp b5
b5:
    %19 = load I32 n
    %20 = cvt F64 %19
    %21 = const F64 3
    %22 = add F64 %20, %21
    %23 = cvt I32 %22
    store I32 n, %23
    jmp b6
b6:
    jmp b12
b7:
    %24 = load F64 x
    %25 = const F64 2
    %26 = gt F64 %24, %25
    br %26, b8, b9
b8:
    %27 = const F64 4
    %28 = cvt I32 %27
    store I32 n, %28
    jmp b12
b9:
    %29 = load bool y
    br %29, b10, b11
b10:
    goto C
b11:
    %30 = const F64 5
    %31 = cvt I32 %30
    store I32 n, %31
    jmp b12
b12:
    %32 = load I32 n
    %33 = cvt F64 %32
    %34 = const F64 2
    %35 = mul F64 %33, %34
    %36 = cvt I32 %35
    store I32 n, %36
    ret
}

state B
step {
b0:
    %0 = load bool y
    br %0, b1, b2
b1:
    goto C
b2:
    goto A
}

state C
step {
b0:
    %0 = load bool y
    br %0, b1, b2
b1:
    goto A
b2:
    goto B
}
