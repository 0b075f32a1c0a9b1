# Of several transitions between the same two states it is not seen which was made; the page says so.
args report app.sm app.ss --format=text -o -

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool on
[Off]
.step
    on = false
    p > 5: -> On
    T > 5000: -> On
[On]
.step
    on = true
    p < 3: -> Off
-- app.ss --
[options]
delta_t 10
[Off]
T == 20: p = 9
[On]
T == 20: p = 0
[all_states]
G == 100: @stop
-- stdout --
app
===
Design review of the state machine in app.sm

At a glance
-----------

The machine has 2 states and begins in `Off`. It watches `p`. It drives `on`.

  States             2
  Transitions        3
  Findings           1
  Scripts            1 of 1 passed
  Seen by scripts    2 of 2 states, 2 of 2 ways; of 1 it is not seen by which transition
  Longest step       7 instructions, in Off
  On an Arduino Uno  about 2659 cycles, 0.17 ms
  Memory on the VM   56 bytes
  Image              101 bytes
  Image CRC          3f41160d
  Source identity    309eb3afc875c983
  State vector       the machine's own

What it does in each state
--------------------------

The machine is run again and again; each time is a step. What stands under "at each step" is done
from top to bottom, in the step in which the machine enters too. The first way out whose condition
holds is taken, and nothing behind it is done any more; the state it leads to begins with the next
step. `T` is the time since the state began, `G` the time.

1. Off [begins here]
  At each step, it
    - sets `on` to `false`
    - leaves for `On` if `p > 5`
    - leaves for `On` if `T > 5000`

Entered from `On`.

2. On
  At each step, it
    - sets `on` to `true`
    - leaves for `Off` if `p < 3`

Entered from `Off`.

Transitions
-----------

In the order of the file. Of two that could be made in one step, the upper one is made.

  No.  From  To   When      In     Line
    1  Off   On   p > 5     .step     9
    2  Off   On   T > 5000  .step    10
    3  On    Off  p < 3     .step    14

Inputs, outputs and parameters
------------------------------

  Element  Type  Role                 Read in  Written in
  G        U64   time
  S        U32   number of the state
  p        F64   input                Off, On
  on       bool  output                        Off, On

Findings
--------

What the analyses found, of all groups. `smc explain` with a name or code prints what it means and
what to do.

  No.  Name             Group     Place        What was found                                          Code
    1  missing-timeout  -Wflight  app.sm:11:2  'On' switches 'on' on and has no way out by time alone  W0921

'On' switches 'on' on and has no way out by time alone [W0921 missing-timeout]
     11 | [On]

    - 'on' is switched on here

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
  Off                 7               7  line 10: 3, line 8: 2, line 9: 2               2659
  On                  5               5  line 14: 3, line 13: 2                         1865

The longest step, in `Off`
  In     Line  Statement        Instructions
  .step     8  on = false                  2
  .step     9  p > 5: -> On                2
  .step    10  T > 5000: -> On             3

On an Arduino Uno
What the worst step takes on an ATmega328P at 16 MHz. It is an estimate: of each instruction the
most that was seen in measurements counts, whatever numbers it works on. Real steps take less, a
third to three quarters of it in tests; that none can take more is not proved. What emitted C takes
there depends on its compiler and is not estimated.

  Part                                        Takes
  Worst step, image in EEPROM                 2659 cycles, 0.17 ms
  Worst step, image in flash                  2154 cycles, 0.14 ms
  Stack below a step, the most that was seen  306 bytes

Memory
RAM of this machine on the VM of a computer with pointers of 64 bits; a board with shorter ones
needs a little less. The state vector, which the application shares, comes on top.

  Part                           Bytes
  Windows of rolling statistics      0
  Locals, and values on the way      0
  The VM's own                      56
  RAM in all                        56
  State vector                      32
  Image, in flash or RAM           101
  of which code                     31

Scripts
-------

  Script  Result  Steps  Asserts that held  States it was in
  app.ss  passed     11                  0  2 of 2

States that the scripts have seen
  State  Times it began  Steps in it  Scripts that were there
  Off                 2            6                        1
  On                  2            5                        1

Ways that the scripts have gone
  From  To   Times  Remark
  Off   On       2  2 transitions, counted together
  On    Off      1

Where no script has been
The scripts have been in every state, and have gone from each to every other it leads to.

Of transitions between the same two states it is not seen which was made: from `Off` to `On` (lines
9, 10). Some of them may never have been.

app.ss [passed]
  Step   G  State that began  Stayed for
     1   0  Off                       30
     4  30  On                        30
     7  60  Off                       30
    10  90  On                the end
