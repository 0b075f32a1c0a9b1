# With --mutate a report lists the changes that no script notices, with inputs that would show them.
args report a.sm a.ss --mutate --format=text | sed -n '/no script notices/,/^Source/p'
args report a.sm bad.ss --mutate --format=text | grep -A 4 'What no script notices'
args report a.sm --mutate --format=text | grep -A 4 'What no script notices'

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[Fill]
.step
    open = p > 700   # the vent
    p > 825: -> Abort

[Abort] @abort @safe

-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 900
G == 20 {
    @assert open
    @stop
}
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 10: @assert open
G == 50: @stop
-- stdout --
What no script notices
----------------------

The machine is changed in one place at a time, and all scripts run again. A change that no script
notices is a fault that these tests would not find. The most dangerous ones come first. On paper,
long tables have their first 20 rows, and the inputs that would show a change are left out.

The scripts notice 4 of 12 changes (33.3 %). Changes that make no difference are not counted: 0.

  State  Noticed  Of
  Fill         4  12

On the way to an abort
  Line  As written         Change that no script notices     Inputs that would show it
    10  p > 825: -> Abort  `p > 825` changed to `0` in Fill  from Fill, at G = 0: p = 900; at G = 10, S differs
    10  p > 825: -> Abort  `>` changed to `>=` in Fill       from Fill, at G = 0: p = 825; at G = 10, S differs
    10  p > 825: -> Abort  `825` changed to `743` in Fill    from Fill, at G = 0: p = 825; at G = 10, S differs
    10  p > 825: -> Abort  `825` changed to `907` in Fill    from Fill, at G = 0: p = 900; at G = 10, S differs
    10  p > 825: -> Abort  `-> Abort` removed in Fill        from Fill, at G = 0: p = 900; at G = 10, S differs

At a hazardous output
  Line  As written      Change that no script notices   Inputs that would show it
     9  open = p > 700  `>` changed to `>=` in Fill     from Fill, at G = 0: p = 700; at G = 0, open differs
     9  open = p > 700  `700` changed to `630` in Fill  from Fill, at G = 0: p = 700; at G = 0, open differs
     9  open = p > 700  `700` changed to `770` in Fill  from Fill, at G = 0: p = 700.7; at G = 0, open differs

What it costs
=============

Costs
-----

VM instructions in the longest step of each state, computed from the image that flies. No step can
take more. The first step of a state also runs `.entry`, and a step that leaves the state also runs
`.exit`. The cycles are those of the step that takes most cycles, which can be another step than
the one with most instructions.

  State  First step  Later steps  Most expensive lines of the longest step  Cycles on AVR
  Fill            7            7  line 9: 4, line 10: 3                              2428
  Abort           0            0                                                      732

The longest step, in `Fill`
  Block  Line  Statement          Instructions
  .step     9  open = p > 700                4
  .step    10  p > 825: -> Abort             3

On an Arduino Uno
The longest step at 16 MHz. This is an estimate: for each instruction it assumes the highest cost
that was measured on an ATmega328P, for any operands. In tests, real steps took between a third and
three quarters of the estimate. It is not proved that no step can take longer. The cost of emitted
C depends on the compiler and is not estimated.

  Part                                     Value
  Longest step, image in EEPROM            2428 cycles, 0.16 ms, in Fill
  Longest step, image in flash             1964 cycles, 0.13 ms, in Fill
  Stack of a step, largest measured        319 bytes
  RAM of state vector, locals and windows  32 bytes of at most 960
  Image                                    97 bytes of at most 960

Memory
RAM of this machine on the VM of a 64-bit computer. A board with shorter pointers needs slightly
less. The state vector is shared with the application and is not included.

  Part                           Bytes
  Windows of rolling statistics      0
  Locals and temporary values        0
  State of the VM                   96
  RAM in total                      96
  State vector                      32
  Image, in flash or RAM            97
  of which code                     18

What no script notices
----------------------

No change of the machine was tried, because every script fails anyway: the first, bad.ss, fails at
bad.ss:4.
What no script notices
----------------------

No change of the machine was tried, because there is no script that could notice it.

-- stderr --
smc: bad.ss failed; the report shows why
smc: Left out: bad.ss, because it fails at bad.ss:4.
smc: --mutate: no change of the machine was tried, because every script fails anyway: the first, bad.ss, fails at bad.ss:4
smc: --mutate: no change of the machine was tried, because there is no script that could notice it
