# The rule of C names both files; blanks in names are kept.
args build -MD --emit=c "a b.sm" && cat *.d

-- a b.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a\ b.h a\ b.c: a\ b.sm
