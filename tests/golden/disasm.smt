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
image of 156 bytes, format 2, crc c676acf2
    section 01 IDENTITY   8 bytes at 44: ae101c3ae1e46017
    section 81 MACHINE    23 bytes at 52
    section 82 CODE       5 bytes at 75
    section 02 DEBUG      76 bytes at 80

machine 1 a
    state vector    16 bytes, layout b1dc9237; of these it names 0 to 16
    states          1
    memory          [..] bytes on a 64-bit computer, of these 0 for locals
    longest step    3 instructions
    output          bool@12 open
    G               U64@0 G
    S               U32@8 S

Idle.step:
     0  ldx     1                               a.sm:7
     2  out     open
     4  end
