# An else-if chain has one block where its arms meet; what stands behind a transition is not built, nor is a block that no way reaches.

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
