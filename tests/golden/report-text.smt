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
[Idle] @swap
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

[Done] @safe @swap

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
    @assert S == Done
    @stop
}
-- stdout --
fill
====
Design review of the state machine in fill.sm

Overview
--------

  Section       Verdict  Details
  Findings      open     2 open
  Scripts       passed   1 of 1 passed
  Coverage      open     33 of 45 places (73 %)
  Longest step           16 instructions, in Fill

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins
of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it  How it is known
  2 open findings         W0206, W0903 (Findings)

Fills a tank.

The machine has 4 states and starts in `Idle`. It reads `level`. It writes `valve`. It never leaves
its final states `Done` and `Abort`.

  States               4
  Transitions          3
  Findings             2
  Scripts              1 of 1 passed
  States covered       3 of 4
  Transitions covered  2 of 3
  Longest step         16 instructions, in Fill
  On an Arduino Uno    about 9597 cycles, 0.60 ms, in Fill
  Memory on the VM     160 bytes on a 64-bit computer
  Image                170 bytes
  Image CRC            4cb8b36a
  Source identity      b6d78073ede69e23
  State vector         declared in the machine

What it does
============

Outputs in each state
---------------------

What each output is after a step in which the machine stays in the state. Several values: which one
depends on conditions or on the path to the state. An expression: the step computes the output from
it; parts that the state decides are left out. "Computed": from more than fits here, or in an
earlier step. "Unchanged": the state does not assign it, so it is what earlier states have left.
"Initial": no state has assigned it yet. Other machines, or a `[start]`, can set other values.

  State  Mark         valve
  Idle                unchanged: initial
  Fill                `false` or `T < 40000`
  Done   safe         unchanged: `false`
  Abort  abort, safe  `false`

States
------

The machine runs in steps. In each step it executes the statements of its state from top to bottom,
also in the step in which it enters the state. The first transition whose condition is true is
taken, and the statements after it are skipped. The next step runs the state to which the
transition leads. `T` is the time since the machine entered the state, `G` is the time.

1. Idle [initial state, swap]
Nothing flows.

  In each step, the machine
    - if `level < 10 and T > 1000`:
      - adds `1` to `pulses`
      - goes to `Fill`

2. Fill
  On entry, the machine
    - sets `valve` to `true`

  In each step, the machine
    - goes to `Done` if `roll_median(level, 5) > full - margin`
      # The gauge is noisy.
    - goes to `Abort` if `T > 60000`
    - otherwise, if `T > 50000`: sets `valve` to `false`
    - otherwise: sets `valve` to `T < 40000`

  On exit, the machine
    - sets `valve` to `false`

Entered from `Idle`.

3. Done [safe to stay, swap]
This state has no statements: the machine does nothing and stays.

Entered from `Fill`.

4. Abort [abort, safe to stay]
  On entry, the machine
    - sets `valve` to `false`

Entered from `Fill`.

Transitions
-----------

In the order of the file, which is their priority: if several can be taken in one step, the machine
takes the first of them.

  No.  From  To     Condition                              Block  Line  Remark
    1  Idle  Fill   level < 10 and T > 1000                .step    19
    2  Fill  Done   roll_median(level, 5) > full - margin  .step    27
    3  Fill  Abort  T > 60000                              .step    28  abort

Inputs, outputs and parameters
------------------------------

  Element   Type  Role          Healthy range  Comment       Read in     Written in
  time (G)  U64   time                         ms
  S         U32   state number
  level     F32   input         0 to 100       percent       Idle, Fill
  valve     bool  output                       lets fuel in              Fill, Abort

Parameters
Named values that the machine never changes.

  Parameter  Type  Value  Formula     Comment  Read in  Line
  full       F64   95                 percent  Fill       10
  margin     F64   5      100 - full           Fill       11

Locals
Variables of the machine. They keep their values from step to step and from state to state.

  Local   Type  Initial value  Read in  Written in  Line
  pulses  U32   0              Idle     Idle          12

Rolling statistics
Every window takes a sample at the start of every step, in every state. Until it is full, its
statistic covers the samples taken so far.

  Call                   Meaning                                      Steps  Line
  roll_median(level, 5)  the median of `level` over the last 5 steps      5    27

What must never happen, and how we know
=======================================

Findings
--------

Findings of all groups of warnings. `smc explain` with a name or code prints what a finding means
and what to do. Time advances by 100 per step, the `delta_t` of the scripts.

  No.  Name            Group          Position      Finding                                                                    Code
    1  unused-local    on by default  fill.sm:12:6  local 'pulses' is read only to compute its own next value                  W0206
    2  output-on-zero  -Wflight       fill.sm:19:9  'level' alone switches on 'valve' when it reads 0, as a broken sensor can  W0903

local 'pulses' is read only to compute its own next value [W0206 unused-local]
     12 | U32  pulses  = 0

'level' alone switches on 'valve' when it reads 0, as a broken sensor can [W0903 output-on-zero]
     19 |         -> Fill

    - 'valve' is switched on here
    - for example in 'Idle': 'level' reads 50, then 0; this happens in step 3 after that
    - require that 'level' is plausible, or that a second sensor agrees

Abort matrix
------------

From which states the machine can abort, and whether it still can if one sensor is dead, stuck or
out of range: with commands, and without. The steps are the worst case, from the step in which a
condition becomes true to the first step of the abort state. They do not include the time until the
condition is true: "after `held`" and "after its window" mark conditions that `held` or a rolling
statistic delays. A counter or a timer delays its condition, too.

  State  Can it abort?      Without a command?  Worst-case steps
  Idle   no                 no
  Fill   yes                yes                 1
  Done   no                 no
  Abort  is an abort state

What each state aborts on
The variables that the guards of aborts read. A state that has no `yes` where most others have one
does not abort on that. Compare it with what the state must do.

  State  time (T)
  Idle   -
  Fill   yes
  Done   -

Transitions that lead to an abort state
  State  To     Condition  Reads  Worst-case steps  Line
  Fill   Abort  T > 60000  time   1                   28

What was tested, and what was not
=================================

Scripts
-------

  Script   Result  Steps  Asserts passed  States visited
  fill.ss  passed    201               1  3 of 4

States visited by the scripts
  State  Times entered  Steps  Scripts
  Idle               1     12        1
  Fill               1     94        1
  Done               1     95        1
  Abort              0      0  none

Transitions taken by the scripts
  From  To     Times  Remark
  Idle  Fill       1
  Fill  Done       1
  Fill  Abort      0  never taken

Not covered by the scripts
No script visits `Abort`. No script takes a transition from `Fill` to `Abort`.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places       Covered  Of  Impossible
  transitions        2   3           0
  statements        10  13           0
  guards             7  10           0
  conditions         8  12           0
  windows            1   1           0
  states             5   6           0

  Line  Not covered
    17  `level < 10` was never false while it decided
    28  `T > 60000` was never true
    29  `T > 50000` was never true
    31  `T < 40000` was never false
    38  state Abort was never entered

fill.ss [passed]
A tank that fills.

  Step      G  State entered       Duration
     1      0  Idle                    1200
    13   1200  Fill                    9400
   107  10600  Done           until the end

What it costs
=============

Costs
-----

VM instructions in the longest step of each state, computed from the image that flies. No step can
take more. The first step of a state also runs `.entry`, and a step that leaves the state also runs
`.exit`. The cycles are those of the step that takes most cycles, which can be another step than
the one with most instructions.

Of each step, 3 instructions take the samples of windows. What a sample costs in addition to its
instruction depends on the window.

  State  First step  Later steps  Most expensive lines of the longest step      Cycles on AVR
  Idle            8            8  line 17: 5, line 27 (samples): 3                       5368
  Fill           16           13  line 31: 5, line 27 (samples): 3, line 24: 3           9597
  Done            3            3  line 27 (samples): 3                                   3591
  Abort           6            3  line 27 (samples): 3, line 40: 3                       3898

The longest step, in `Fill`
  Block    Line  Statement                                       Instructions
  samples    27  roll_median(level, 5) > full - margin: -> Done             3
  .entry     24  valve = true                                               3
  .step      27  roll_median(level, 5) > full - margin: -> Done             2
  .step      28  if T > 60000: -> Abort                                     2
  .step      29  else if T > 50000: valve = false                           1
  .step      31  valve = T < 40000                                          5

On an Arduino Uno
The longest step at 16 MHz. This is an estimate: for each instruction it assumes the highest cost
that was measured on an ATmega328P, for any operands. In tests, real steps took between a third and
three quarters of the estimate. It is not proved that no step can take longer. The cost of emitted
C depends on the compiler and is not estimated.

  Part                                     Value
  Longest step, image in EEPROM            9597 cycles, 0.60 ms, in Fill
  Longest step, image in flash             8916 cycles, 0.56 ms, in Fill
  Stack of a step, largest measured        319 bytes
  RAM of state vector, locals and windows  80 bytes of at most 960
  Image                                    170 bytes of at most 960

Memory
RAM of this machine on the VM of a 64-bit computer. A board with shorter pointers needs slightly
less. The state vector is shared with the application and is not included.

  Part                           Bytes
  Windows of rolling statistics     56
  Locals and temporary values        0
  State of the VM                  104
  RAM in total                     160
  State vector                      24
  Image, in flash or RAM           170
  of which code                     72
