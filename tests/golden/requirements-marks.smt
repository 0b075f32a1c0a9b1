# Marks change neither the C of a machine, nor its image, but for the hash of its source.
args build a.sm -o marked.smb && "$SMC" build plain/a.sm -o plain.smb && "$SMC" disasm marked.smb | sed 1,2d >1 && "$SMC" disasm plain.smb | sed 1,2d >2 && cmp 1 2 && "$SMC" build a.sm --emit=c -o a.c && "$SMC" build plain/a.sm --emit=c -o plain/a.c && cmp a.c plain/a.c && cmp a.h plain/a.h && grep -c @req a.sm

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad] @req R1
.step
    p > 100: -> Drogue @req R3
[Drogue]
.entry
    drogue = true @req R4
.step
    if T > 50 { -> Main } @req R3
[Main] @safe
.entry
    main = true
-- plain/a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad]
.step
    p > 100: -> Drogue
[Drogue]
.entry
    drogue = true
.step
    if T > 50 { -> Main }
[Main] @safe
.entry
    main = true
-- stdout --
4
