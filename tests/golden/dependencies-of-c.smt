# The rule of C names both files, the .c first; blanks in names are kept.
args build -MD --emit=c "a b.sm" && cat *.d
args build -MD --emit=c --soft "a b.sm" && ls *.d && cat *.d

-- a b.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a\ b.c a\ b.h: a\ b.sm
a b.d
a\ b.c a\ b.h sm_soft.h sm_soft.c sm_soft_avr.S: a\ b.sm
