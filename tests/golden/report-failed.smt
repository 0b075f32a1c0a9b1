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

At a glance
-----------

The machine has 1 state and begins in `Idle`. It watches `x`. It drives `valve`. Once in `Idle`, it
stays there.

  States             1
  Transitions        0
  Findings          [..]
  Scripts            0 of 2 passed
  Seen by scripts    1 of 1 states, 0 of 0 ways
  Longest step       5 instructions, in Idle
  On an Arduino Uno  about [..] ms
  Memory on the VM   56 bytes on a 64-bit computer
  Image              76 bytes
  Image CRC          f712cd1a
  Source identity    2f257f5f61796867
  State vector       the machine's own

What it does in each state
--------------------------

The machine is run again and again; each time is a step. What stands under "at each step" is done
from top to bottom, in the step in which the machine enters too. The first way out whose condition
holds is taken, and nothing behind it is done any more; the state it leads to begins with the next
step. `T` is the time since the state began, `G` the time.

1. Idle [begins here]
  At each step, it
    - sets `valve` to `x > 5`

Transitions
-----------

There are none: the machine stays in its first state.

Inputs, outputs and parameters
------------------------------

  Element  Type  Role                 Read in  Written in
  G        U64   time
  S        U32   number of the state
  x        F32   input                Idle
  valve    bool  output                        Idle

Findings
--------
...
Abort matrix
------------

No state is marked `@abort`, so nothing can be said about how this machine aborts. Write the mark
behind the header of the state where it goes when something is wrong, as in `[Abort] @abort`.

What it costs
-------------

Instructions of the VM in the longest step of each state, found on the very image that flies; no
step can take more. The first step of a state runs `.entry` too, and a step that leaves runs
`.exit`.

  State  Its first step  Any other step  Dearest lines of its longest step  Cycles on an Uno
  Idle                5               5  line 8: 5[..]

The longest step, in `Idle`
  In     Line  Statement      Instructions
  .step     8  valve = x > 5             5

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
  Windows of rolling statistics      0
  Locals, and values on the way      0
  The VM's own                      56
  RAM in all                        56
  State vector                      24
  Image, in flash or RAM            76
  of which code                      9

Scripts
-------

  Script  Result                          Steps  Asserts that held  States it was in
  bad.ss  failed: an assert did not hold      6                  5  1 of 1
  odd.ss  does not compile                    0                  0  0 of 1

States that the scripts have seen
  State  Times it began  Steps in it  Scripts that were there
  Idle                1            6                        1

Where no script has been
Nowhere: the scripts have been in every state and gone every way from one state to another.

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

  Step  G  State that began  Stayed for
     1  0  Idle              the end

odd.ss [failed]
unknown element 'y' [E0204]

      4 | G == 50: y = 6

the script has no @stop, so it would never end [E0703]

      1 | [options]
-- stderr --
smc: bad.ss failed; the report says why
smc: odd.ss failed; the report says why
broken.sm:6:5: error: unknown element 'x' [E0204]
    6 |     x = 1
      |     ^
1 error
smc: cannot read 'missing.ss': No such file or directory
-- exit --
1 1 3
