# A local that no statement stores is a member of its own: the header says that a change there has no effect.
args build -w --emit=c -o a.c a.sm && sed -n '/\[local\]/,/^}/p' a.h

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool v
[local]
F64 limit = 3
F64 n = 0
[A]
.step
    n = n + 1
    v = p > limit or n > 5
-- stdout --
    // [local]
    double   n;

    // [local], never stored: the code contains their values, and a change here has no defined effect
    double   limit;
} A;
