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
image of 483 bytes, format 1, crc db9303e7
    section 01 IDENTITY   8 bytes at 52: 003740f815ec1432
    section 81 MACHINE    108 bytes at 60
    section 82 CODE       68 bytes at 168
    section 83 INIT       16 bytes at 236
    section 02 DEBUG      231 bytes at 252

machine 1 sub
    state vector    32 bytes, layout f4b2fddc
    states          2
    memory          [..] bytes on this machine, of these 11 for locals
    operands        17
    longest step    15 instructions
    output          F64@16 rate
    output          I8@24 count
    G               U64@0 time
    S               U32@8 state
    initial value   local F64@0 = 0x3fb999999999999a
    initial value   local U16@8 = 0x0003
    w0              5 F32 samples: average
    w1              3 F64 samples: range

sample:
     0  sample  w0, pressure                    sub.sm:18
     3  sub     acc, pressure, rate             sub.sm:19
     7  sample  w1, acc
    10  end

Hold.entry:
    11  mov     count, -1                       sub.sm:15
    14  end

Hold.step:
    15  avg     acc, w0                         sub.sm:18
    18  mul     rate, acc, 0.1
    22  range   acc, w1                         sub.sm:19
    25  jnlt    0x1.7e43c8800759cp+996, acc, 38
    29  jf      armed, 38
    32  add     count, count, 0.5               sub.sm:20
    36  goto    Vent                            sub.sm:21
    38  le      t0, 10.5, pressure              sub.sm:23
    42  lt      acc, T, 1000000
    46  or      armed, t0, acc
    50  end

Hold.exit:
    51  mov     limit, 4                        sub.sm:25
    54  end

Vent.step:
    55  neg     acc, rate                       sub.sm:28
    58  sqrt    rate, acc
    61  jnlt    limit, count, 67                sub.sm:29
    65  goto    Hold
    67  end
image of 233 bytes, format 1, crc 1b5cca8b
    section 01 IDENTITY   8 bytes at 44: 003740f815ec1432
    section 81 MACHINE    108 bytes at 52
    section 82 CODE       68 bytes at 160
    section 83 INIT       5 bytes at 228

machine 1 
    state vector    32 bytes, layout f4b2fddc
    states          2
    memory          [..] bytes on this machine, of these 3 for locals
    operands        17
    longest step    15 instructions
    output          F64@16
    output          I8@24
    G               U64@0
    S               U32@8
    initial value   local U16@0 = 0x0003
    w0              5 F32 samples: average
    w1              3 F64 samples: range

sample:
     0  sample  w0, F32@12
     3  sub     acc, F32@12, F64@16
     7  sample  w1, acc
    10  end

state 1.entry:
    11  mov     I8@24, -1
    14  end

state 1.step:
    15  avg     acc, w0
    18  mul     F64@16, acc, 0.1
    22  range   acc, w1
    25  jnlt    0x1.7e43c8800759cp+996, acc, 38
    29  jf      local bool@2, 38
    32  add     I8@24, I8@24, 0.5
    36  goto    state 2
    38  le      t0, 10.5, F32@12
    42  lt      acc, T, 1000000
    46  or      local bool@2, t0, acc
    50  end

state 1.exit:
    51  mov     local U16@0, 4
    54  end

state 2.step:
    55  neg     acc, F64@16
    58  sqrt    F64@16, acc
    61  jnlt    local U16@0, I8@24, 67
    65  goto    state 1
    67  end
image of 146 bytes, format 1, crc 54f41514
    section 01 IDENTITY   8 bytes at 44: 9d78ceec3f98183c
    section 81 MACHINE    24 bytes at 52
    section 82 CODE       0 bytes at 76
    section 02 DEBUG      70 bytes at 76

machine 1 idle
    state vector    16 bytes, layout ddcc0f93
    states          1
    memory          [..] bytes on this machine, of these 0 for locals
    operands        2
    longest step    0 instructions
    G               U64@0 G
    S               U32@8 S
sub.smb: machine 1: 2 states, longest step 15 instructions, [..] bytes of RAM, state vector 32 bytes (layout f4b2fddc)
idle.smb: machine 1: 1 states, longest step 0 instructions, [..] bytes of RAM, state vector 16 bytes (layout ddcc0f93)
