# --prefix names what emitted C declares.
args build --emit=c --prefix=valve -o v.c a.sm && ls && grep -c valve_step v.h

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a.sm
v.c
v.h
1
