# A transition that several lines make is one instruction in the image, and belongs to none of them.
args build -g a.sm
args disasm a.smb
args report a.sm --format=text -o out.txt

-- a.sm --
[state_vector]
U64 G
U32 S
F32 x @read_only
bool valve
[Idle]
.step
    x > 5: -> Done
    T > 5: -> Done
    valve = true
.exit
    valve = x > 4
[Done]
-- stdout --
image of 207 bytes, format 2, crc e30872b0
    section 01 IDENTITY   8 bytes at 44: 2dba7ab2f688aefb
    section 81 MACHINE    26 bytes at 52
    section 82 CODE       25 bytes at 78
    section 02 DEBUG      104 bytes at 103

machine 1 a
    state vector    24 bytes, layout 0ebeba96; of these it names 0 to 24
    states          2
    memory          [..] bytes on a 64-bit computer, of these 0 for locals
    longest step    10 instructions
    output          bool@16 valve
    G               U64@0 G
    S               U32@8 S

Idle.step:
     0  ldx     x                               a.sm:8
     2  jxn     x > 5, 14
     5  ldx     T                               a.sm:9
     6  jxn     x > 5, 14
     9  ldx     1                               a.sm:10
    11  out     valve
    13  end
    14  goto    Done

Idle.exit:
    16  ldx     x                               a.sm:12
    18  ldy     4
    20  set     x > y
    22  out     valve
    24  end
-- file out.txt --
a
...
The longest step, in `Idle`
  Block  Line  Statement            Instructions
  .step     8  x > 5: -> Done                  2
  .step     9  T > 5: -> Done                  2
  .step        -> of several lines             1
  .exit    12  valve = x > 4                   5

...
