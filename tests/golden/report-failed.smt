# A script that fails, or does not compile, is in the report, and the exit code says so; a machine with errors gives no report.
args report a.sm bad.ss odd.ss --format=text -o out.txt
args report broken.sm -o broken.html
args report a.sm missing.ss -o missing.html

-- a.sm --
[state_vector]
U64 G
U32 S
F32 x @read_only
bool valve
[Idle]
.step
    valve = x > 5
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 50: x = 6
true: @assert not valve
G == 100: @stop
-- odd.ss --
[options]
delta_t 10
[all_states]
G == 50: y = 6
-- broken.sm --
[state_vector]
U64 G
U32 S
[Idle]
.step
    x = 1
-- file out.txt --
a
=
Design review of the state machine in a.sm

Overview
--------

  Section       Verdict  Details
  Findings      passed   none
  Scripts       failed   0 of 2 passed
  Coverage      passed   6 of 6 places (100 %)
  Longest step           5 instructions, in Idle

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins
of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it  How it is known
  script bad.ss           it fails (Scripts)
  script odd.ss           it does not compile (Scripts)

The machine has 1 state and starts in `Idle`. It reads `x`. It writes `valve`. It never leaves
`Idle`.

  States               1
  Transitions          0
  Findings             none
  Scripts              0 of 2 passed
  States covered       1 of 1
  Transitions covered  0 of 0
  Longest step         5 instructions, in Idle
  On an Arduino Uno    about 1817 cycles, 0.12 ms, in Idle
  Memory on the VM     96 bytes on a 64-bit computer
  Image                76 bytes
  Image CRC            f712cd1a
  Source identity      2f257f5f61796867
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

  State  valve
  Idle   `x > 5`

States
------

The machine runs in steps. In each step it executes the statements of its state from top to bottom,
also in the step in which it enters the state. The first transition whose condition is true is
taken, and the statements after it are skipped. The next step runs the state to which the
transition leads. `T` is the time since the machine entered the state, `G` is the time.

1. Idle [initial state]
  In each step, the machine
    - sets `valve` to `x > 5`

Transitions
-----------

The machine has no transitions: it stays in its first state.

Inputs, outputs and parameters
------------------------------

  Element  Type  Role          Read in  Written in
  G        U64   time
  S        U32   state number
  x        F32   input         Idle
  valve    bool  output                 Idle

What must never happen, and how we know
=======================================

Findings
--------

The analyses of all groups found nothing. Time advances by 10 per step, the `delta_t` of the
scripts.

Abort matrix
------------

No state is marked `@abort`, so the report cannot show how this machine aborts. Put the mark after
the header of the state that handles failures, as in `[Abort] @abort`.

What was tested, and what was not
=================================

Scripts
-------

  Script  Result                       Steps  Asserts passed  States visited
  bad.ss  failed: an assert was false      6               5  1 of 1
  odd.ss  does not compile                 0               0  0 of 1

States visited by the scripts
  State  Times entered  Steps  Scripts
  Idle               1      6        1

Not covered by the scripts
Nothing: the scripts visit every state and take every transition.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places      Covered  Of  Impossible
  statements        1   1           0
  guards            2   2           0
  conditions        2   2           0
  states            1   1           0

bad.ss [failed]
assert failed after step 6 (G = 50, state Idle) [E0750]

      5 | true: @assert not valve
        | valve = true

  the last steps, and the values after each:
  step   G  state  valve
     2  10  Idle   false
     3  20  Idle   false
     4  30  Idle   false
     5  40  Idle   false
     6  50  Idle    true
  the machine has been in state 'Idle' from the start
  a.sm:8: step 6 (G = 50): `valve = x > 5` stored true: x = 6

  Step  G  State entered  Duration
     1  0  Idle           until the end

odd.ss [failed]
unknown element 'y' [E0204]

      4 | G == 50: y = 6

the script has no @stop, so it would never end [E0703]

      1 | [options]

What it costs
=============

Costs
-----

VM instructions in the longest step of each state, computed from the image that flies. No step can
take more. The first step of a state also runs `.entry`, and a step that leaves the state also runs
`.exit`. The cycles are those of the step that takes most cycles, which can be another step than
the one with most instructions.

  State  First step  Later steps  Most expensive lines of the longest step  Cycles on AVR
  Idle            5            5  line 8: 5                                          1817

The longest step, in `Idle`
  Block  Line  Statement      Instructions
  .step     8  valve = x > 5             5

On an Arduino Uno
The longest step at 16 MHz. This is an estimate: for each instruction it assumes the highest cost
that was measured on an ATmega328P, for any operands. In tests, real steps took between a third and
three quarters of the estimate. It is not proved that no step can take longer. The cost of emitted
C depends on the compiler and is not estimated.

  Part                                     Value
  Longest step, image in EEPROM            1817 cycles, 0.12 ms, in Idle
  Longest step, image in flash             1500 cycles, 0.10 ms, in Idle
  Stack of a step, largest measured        319 bytes
  RAM of state vector, locals and windows  24 bytes of at most 960
  Image                                    76 bytes of at most 960

Memory
RAM of this machine on the VM of a 64-bit computer. A board with shorter pointers needs slightly
less. The state vector is shared with the application and is not included.

  Part                           Bytes
  Windows of rolling statistics      0
  Locals and temporary values        0
  State of the VM                   96
  RAM in total                      96
  State vector                      24
  Image, in flash or RAM            76
  of which code                      9
-- stderr --
smc: bad.ss failed; the report shows why
smc: odd.ss failed; the report shows why
broken.sm:6:5: error: unknown element 'x' [E0204]
    6 |     x = 1
      |     ^
1 error
smc: cannot read 'missing.ss': No such file or directory
-- exit --
1 1 3
