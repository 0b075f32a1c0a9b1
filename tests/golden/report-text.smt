# What smc report says of a machine, for a terminal: marks, ranges, comments, parameters, windows, an allowed finding, costs, a script.
args report fill.sm fill.ss --format=text

-- fill.sm --
# Fills a tank.

[state_vector]
U64   time    @alias G      # ms
U32   S
F32   level   @read_only @range 0 100   # percent
bool  valve                 # lets fuel in

[local]
F64  full    = 95   @read_only  # percent
F64  margin  = 100 - full @read_only
U32  pulses  = 0

# Nothing flows.
[Idle]
.step
    if level < 10 and T > 1000 {
        pulses = pulses + 1
        -> Fill
    }

[Fill]
.entry
    valve = true
.step
    # The gauge is noisy.
    roll_median(level, 5) > full - margin: -> Done
    if T > 60000: -> Abort
    else if T > 50000: valve = false
    else {
        valve = T < 40000
    }
.exit
    valve = false

[Done] @safe

[Abort] @abort @safe
.entry
    valve = false
-- fill.ss --
# A tank that fills.
[options]
delta_t 100
[all_states]
valve: level = level + 1
G == 20000 {
    @assert S == 3
    @stop
}
-- stdout --
fill
====
Design review of the state machine in fill.sm

At a glance
-----------

Fills a tank.

The machine has 4 states and begins in `Idle`. It watches `level`. It drives `valve`. Once in one
of `Done`, `Abort`, it stays there.

  States             4
  Transitions        3
  Findings          [..]
  Scripts            1 of 1 passed
  Seen by scripts    3 of 4 states, 2 of 3 ways
  Longest step       16 instructions, in Fill
  On an Arduino Uno  about [..] ms
  Memory on the VM   120 bytes on a 64-bit computer
  Image              161 bytes
  Image CRC          6677e475
  Source identity    5acf0981b6a5ecb5
  State vector       the machine's own

What it does in each state
--------------------------

The machine is run again and again; each time is a step. What stands under "at each step" is done
from top to bottom, in the step in which the machine enters too. The first way out whose condition
holds is taken, and nothing behind it is done any more; the state it leads to begins with the next
step. `T` is the time since the state began, `G` the time.

1. Idle [begins here]
Nothing flows.

  At each step, it
    - if `level < 10 and T > 1000`:
      - adds `1` to `pulses`
      - leaves for `Fill`

2. Fill
  When it enters, it
    - sets `valve` to `true`

  At each step, it
    - leaves for `Done` if `roll_median(level, 5) > full - margin`
      # The gauge is noisy.
    - leaves for `Abort` if `T > 60000`
    - otherwise, if `T > 50000`: sets `valve` to `false`
    - otherwise: sets `valve` to `T < 40000`

  When it leaves, it
    - sets `valve` to `false`

Entered from `Idle`.

3. Done [safe to stay]
In this state the machine does nothing, and stays.

Entered from `Fill`.

4. Abort [abort, safe to stay]
  When it enters, it
    - sets `valve` to `false`

Entered from `Fill`.

Transitions
-----------

In the order of the file. Of two that could be made in one step, the upper one is made.

  No.  From  To     When                                   In     Line  Remark
    1  Idle  Fill   level < 10 and T > 1000                .step    19
    2  Fill  Done   roll_median(level, 5) > full - margin  .step    27
    3  Fill  Abort  T > 60000                              .step    28  abort

Inputs, outputs and parameters
------------------------------

  Element   Type  Role                 Healthy range  Meaning, as its author wrote  Read in     Written in
  time (G)  U64   time                                ms
  S         U32   number of the state
  level     F32   input                0 to 100       percent                       Idle, Fill
  valve     bool  output                              lets fuel in                              Fill, Abort

Parameters
Numbers with a name that the machine itself never changes.

  Parameter  Type  Value  Written as  Meaning, as its author wrote  Read in  Line
  full       F64   95                 percent                       Fill       10
  margin     F64   5      100 - full                                Fill       11

What it remembers
Variables of the machine's own. They keep their values from step to step and from state to state.

  Local   Type  Begins as  Read in  Written in  Line
  pulses  U32   0          Idle     Idle          12

Rolling statistics
Every window takes a sample at the start of every step, in whatever state the machine is. Until it
is full, statistics are over the samples there are.

  Call                   What it gives                                Steps  Line
  roll_median(level, 5)  the median of `level` over the last 5 steps      5    27

Findings
--------
...
Abort matrix
------------
...
What it costs
-------------

Instructions of the VM in the longest step of each state, found on the very image that flies; no
step can take more. The first step of a state runs `.entry` too, and a step that leaves runs
`.exit`.

3 instructions of each step give the windows their samples; what a sample takes beyond its
instruction depends on the window.

  State  Its first step  Any other step  Dearest lines of its longest step             Cycles on an Uno
  Idle                8               8  line 17: 5, line 27 (samples): 3[..]
  Fill               16              13  line 31: 5, line 27 (samples): 3, line 24: 3[..]
  Done                3               3  line 27 (samples): 3[..]
  Abort               6               3  line 27 (samples): 3, line 40: 3[..]

The longest step, in `Fill`
  In       Line  Statement                                       Instructions
  samples    27  roll_median(level, 5) > full - margin: -> Done             3
  .entry     24  valve = true                                               3
  .step      27  roll_median(level, 5) > full - margin: -> Done             2
  .step      28  if T > 60000: -> Abort                                     2
  .step      29  else if T > 50000: valve = false                           1
  .step      31  valve = T < 40000                                          5

On an Arduino Uno
What the worst step takes on an ATmega328P at 16 MHz. It is an estimate: of each instruction the
most that was seen in measurements counts, whatever numbers it works on. Real steps take less, a
third to three quarters of it in tests; that none can take more is not proved. What emitted C takes
there depends on its compiler and is not estimated.

  Part                                        Takes
  Worst step, image in EEPROM[..] ms
  Worst step, image in flash[..] ms
  Stack below a step, the most that was seen[..] bytes

Memory
RAM of this machine on the VM of a computer with pointers of 64 bits; a board with shorter ones
needs a little less. The state vector, which the application shares, comes on top.

  Part                           Bytes
  Windows of rolling statistics     56
  Locals, and values on the way      0
  The VM's own                      64
  RAM in all                       120
  State vector                      24
  Image, in flash or RAM           161
  of which code                     72

Scripts
-------

  Script   Result  Steps  Asserts that held  States it was in
  fill.ss  passed    201                  1  3 of 4

States that the scripts have seen
  State  Times it began  Steps in it  Scripts that were there
  Idle                1           12                        1
  Fill                1           94                        1
  Done                1           95                        1
  Abort               0            0  none

Ways that the scripts have gone
  From  To     Times  Remark
  Idle  Fill       1
  Fill  Done       1
  Fill  Abort      0  never gone

Where no script has been
fill.ss [passed]
A tank that fills.

  Step      G  State that began  Stayed for
     1      0  Idle                    1200
    13   1200  Fill                    9400
   107  10600  Done              the end
