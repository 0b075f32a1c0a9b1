# Which states are marked @safe is in the image, of a machine that marks any.
args build -w a.sm b.sm --sv v.sv
args disasm a.smb

-- v.sv --
[V]
U64 G
U32 S
bool go
-- a.sm --
[state_vector]
U64 G
U32 S
bool go
[One] .step
    go: -> Two
[Two] @safe .step
    go: -> Three
[Three] .step
    go: -> Four
[Four] @abort @safe
-- b.sm --
[state_vector]
U64 G
U32 S
bool go
[One]
-- stdout --
image of 139 bytes, format 2, crc ac71c9db
    section 01 IDENTITY   8 bytes at 60: f28a7d28a612097a
    section 81 MACHINE    29 bytes at 68
    section 82 CODE       21 bytes at 97
    section 05 SAFE       1 bytes at 118
    section 81 MACHINE    20 bytes at 119
    section 82 CODE       0 bytes at 139

machine 1 
    state vector    16 bytes, layout 78488c75; of these it names 0 to 16
    states          4
    safe states     2 4
    memory          [..] bytes on a 64-bit computer, of these 0 for locals
    longest step    3 instructions
    G               U64@0
    S               U32@8

state 1.step:
     0  ldx     bool@12
     2  jt      5
     4  end
     5  goto    state 2

state 2.step:
     7  ldx     bool@12
     9  jt      12
    11  end
    12  goto    state 3

state 3.step:
    14  ldx     bool@12
    16  jt      19
    18  end
    19  goto    state 4

machine 2 
    state vector    16 bytes, layout 78488c75; of these it names 0 to 16
    states          1
    memory          [..] bytes on a 64-bit computer, of these 0 for locals
    longest step    0 instructions
    G               U64@0
    S               U32@8
