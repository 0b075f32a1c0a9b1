# A machine with names and lines, in a folder; then without, and one that does nothing.
args build -g -Wno-never-written sub.sm
args disasm sub.smb
args build --strip -Wno-never-written sub.sm
args disasm sub.smb
args build -g idle.sm
args disasm idle.smb
args verify sub.smb idle.smb

-- sub.sm --
[state_vector]
U64  time   @alias G
U32  state  @alias S
F32  pressure  @read_only
F64  rate
I8   count

[local]
F64 scale = 0.1
U16 limit = 3
bool armed = false

[Hold]
.entry
    count = -1

.step
    rate = roll_avg(pressure, 5) * scale
    if roll_range(pressure - rate, 3) > 1e300 and armed {
        count = count + 0.5
        -> Vent
    }
    armed = pressure >= 10.5 or T < 1000000
.exit
    limit = 4
[Vent]
.step
    rate = sqrt(-rate)
    count > limit: -> Hold
-- idle.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stdout --
image of 462 bytes, format 2, crc 7e5597ca
    section 01 IDENTITY   8 bytes at 52: 003740f815ec1432
    section 81 MACHINE    53 bytes at 60
    section 82 CODE       85 bytes at 113
    section 83 INIT       16 bytes at 198
    section 02 DEBUG      248 bytes at 214

machine 1 sub
    state vector    32 bytes, layout f4b2fddc; of these it names 0 to 32
    states          2
    memory          [..] bytes on a 64-bit computer, of these 12 for locals
    longest step    29 instructions
    output          I8@24 count
    output          F64@16 rate
    G               U64@0 time
    S               U32@8 state
    initial value   local F64@0 = 0x3fb999999999999a
    initial value   local U16@8 = 0x0003
    w0              5 F32 samples: average of roll(pressure, 5)
    w1              3 F64 samples: range of roll(pressure - rate, 3)

sample:
     0  ldx     pressure                        sub.sm:18
     2  sample  w0
     4  ldy     rate                            sub.sm:19
     6  sub
     7  sample  w1
     9  end

Hold.entry:
    10  ldx     -1                              sub.sm:15
    12  out     count
    14  end

Hold.step:
    15  stat    average, w0                     sub.sm:18
    18  ldy     scale
    20  mul
    21  out     rate
    23  stat    range, w1                       sub.sm:19
    26  ldy     0x1.7e43c8800759cp+996
    28  jxy     not x > y, 34
    30  ldx     armed
    32  jt      56
    34  ldx     T                               sub.sm:23
    35  ldy     1000000
    40  set     x < y
    42  st      local bool@11
    44  ldx     pressure
    46  ldy     10.5
    48  set     x >= y
    50  ldy     local bool@11
    52  or
    53  st      armed
    55  end
    56  ldx     count                           sub.sm:20
    58  ldy     0.5
    60  add
    61  out     count
    63  goto    Vent                            sub.sm:21

Hold.exit:
    65  ldx     4                               sub.sm:25
    67  st      limit
    69  end

Vent.step:
    70  ldx     rate                            sub.sm:28
    72  neg
    73  sqrt
    74  out     rate
    76  ldx     count                           sub.sm:29
    78  ldy     limit
    80  jxy     x > y, 83
    82  end
    83  goto    Hold
image of 203 bytes, format 2, crc 7dd3e985
    section 01 IDENTITY   8 bytes at 44: 003740f815ec1432
    section 81 MACHINE    61 bytes at 52
    section 82 CODE       85 bytes at 113
    section 83 INIT       5 bytes at 198

machine 1 
    state vector    32 bytes, layout f4b2fddc; of these it names 0 to 32
    states          2
    memory          [..] bytes on a 64-bit computer, of these 4 for locals
    longest step    29 instructions
    output          I8@24
    output          F64@16
    G               U64@0
    S               U32@8
    initial value   local U16@0 = 0x0003
    w0              5 F32 samples: average
    w1              3 F64 samples: range

sample:
     0  ldx     F32@12
     2  sample  w0
     4  ldy     F64@16
     6  sub
     7  sample  w1
     9  end

state 1.entry:
    10  ldx     -1
    12  out     I8@24
    14  end

state 1.step:
    15  stat    average, w0
    18  ldy     0.1
    20  mul
    21  out     F64@16
    23  stat    range, w1
    26  ldy     0x1.7e43c8800759cp+996
    28  jxy     not x > y, 34
    30  ldx     local bool@2
    32  jt      56
    34  ldx     T
    35  ldy     1000000
    40  set     x < y
    42  st      local bool@3
    44  ldx     F32@12
    46  ldy     10.5
    48  set     x >= y
    50  ldy     local bool@3
    52  or
    53  st      local bool@2
    55  end
    56  ldx     I8@24
    58  ldy     0.5
    60  add
    61  out     I8@24
    63  goto    state 2

state 1.exit:
    65  ldx     4
    67  st      local U16@0
    69  end

state 2.step:
    70  ldx     F64@16
    72  neg
    73  sqrt
    74  out     F64@16
    76  ldx     I8@24
    78  ldy     local U16@0
    80  jxy     x > y, 83
    82  end
    83  goto    state 1
image of 139 bytes, format 2, crc 41a16e26
    section 01 IDENTITY   8 bytes at 44: 9d78ceec3f98183c
    section 81 MACHINE    20 bytes at 52
    section 82 CODE       0 bytes at 72
    section 02 DEBUG      67 bytes at 72

machine 1 idle
    state vector    16 bytes, layout ddcc0f93; of these it names 0 to 16
    states          1
    memory          [..] bytes on a 64-bit computer, of these 0 for locals
    longest step    0 instructions
    G               U64@0 G
    S               U32@8 S
sub.smb: machine 1: 2 states, longest step 29 instructions, [..] bytes of RAM on a 64-bit computer, state vector 32 bytes (layout f4b2fddc)
idle.smb: machine 1: 1 state, longest step 0 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout ddcc0f93)
