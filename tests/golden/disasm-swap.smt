# An image with names has the marks of states, and the canonical names of what windows sample.
args build -w -g a.sm
args disasm a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
F64 pressure @alias p
bool b
[local]
U16 limit = 300 @read_only
U8 count = 3
[One] @swap
.step
    roll_avg(p + 1, 10) > limit: b = true
    roll_max(-p * (limit - 2) + count, 5) > 1: -> Two
[Two] @safe @swap
.step
    roll_median(roll_min(p, 3) < count <= 2, 4) > roll_max(p + 1, 10): -> Three
[Three] @abort
-- stdout --
image of 505 bytes, format 2, crc 88bdf556
    section 01 IDENTITY   8 bytes at 76: cec13d3fa38d3363
    section 81 MACHINE    45 bytes at 84
    section 82 CODE       78 bytes at 129
    section 83 INIT       4 bytes at 207
    section 05 SAFE       1 bytes at 211
    section 07 SWAP       1 bytes at 212
    section 08 ABORT      1 bytes at 213
    section 02 DEBUG      291 bytes at 214

machine 1 a
    state vector    32 bytes, layout 23a038e9; of these it names 0 to 32
    states          3
    safe states     2
    swap states     1 2
    abort states    3
    memory          330 bytes on a 64-bit computer, of these 10 for locals
    longest step    30 instructions
    output          bool@24 b
    G               U64@0 G
    S               U32@8 S
    initial value   local U8@8 = 0x03
    w0              10 F64 samples: average largest of roll(pressure + 1, 10)
    w1              5 F64 samples: largest of roll(((-pressure) * 298) + U8 count, 5)
    w2              3 F64 samples: smallest of roll(pressure, 3)
    w3              4 U8 samples: median of roll(roll_min(pressure, 3) < U8 count <= 2, 4)

sample:
     0  ldx     pressure                        a.sm:11
     2  addi    1
     4  sample  w0
     6  ldx     pressure                        a.sm:12
     8  neg
     9  ldy     298
    12  mul
    13  ldy     count
    15  add
    16  sample  w1
    18  ldx     pressure                        a.sm:15
    20  sample  w2
    22  stat    smallest, w2
    25  ldy     count
    27  set     x < y
    29  st      local bool@9
    31  ldx     count
    33  ldy     2
    35  set     x <= y
    37  ldy     local bool@9
    39  and
    40  sample  w3
    42  end

One.step:
    43  stat    average, w0                     a.sm:11
    46  jxn     not x > 300, 54
    50  ldx     1
    52  out     b
    54  stat    largest, w1                     a.sm:12
    57  jxn     x > 1, 61
    60  end
    61  goto    Two

Two.step:
    63  stat    largest, w0                     a.sm:15
    66  st      local RAW@0
    68  stat    median, w3
    71  ldy     local RAW@0
    73  jxy     x > y, 76
    75  end
    76  goto    Three
