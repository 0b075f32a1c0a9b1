# An image as text.
args build -g a.sm
args disasm a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
image of 170 bytes, format 1, crc a4957f16
    section 01 IDENTITY   8 bytes at 44: ae101c3ae1e46017
    section 81 MACHINE    30 bytes at 52
    section 82 CODE       4 bytes at 82
    section 02 DEBUG      84 bytes at 86

machine 1 a
    state vector    16 bytes, layout b1dc9237
    states          1
    memory          [..] bytes on this machine, of these 0 for locals
    operands        4
    longest step    2 instructions
    output          bool@12 open
    G               U64@0 G
    S               U32@8 S

Idle.step:
     0  mov     open, 1                         a.sm:7
     3  end
