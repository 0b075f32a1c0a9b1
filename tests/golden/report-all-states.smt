# A report shows [all_states], definitions, times and windows in time once, as they are written; a transition counts once, with the states
# from which it was taken, and where a state has one to the same target, a run does not show which was taken.
args report a.sm a.ss b.ss --format=text | sed -n '/^  Transitions /p; /^  Step  *[0-9n]/p; /^  Unit/p; /^In all states/,/^1. Idle/p; /^2. Fill/,/^Inputs/p; /Used in/,/^What must/p; /declares/p; /^Transitions that lead/,/^What was/p; /^Transitions taken/,/^a.ss/p'

-- a.sm --
# Fills a tank.
[options]
step 20 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool stop @read_only
bool valve
U8 why

[define]
slow = 40 ms
# Above this the relief valve opens.
most = 50                              # bar
high = roll_min(p, slow) > most
burn = 1.5 s

# The operator's button, and what the sensors report.
[all_states] @except Abort             # in every phase
.step
    stop: -> Abort                     # let go
    high {
        # 2: pressure
        why = 2
        -> Abort
    }

[all_states] @except Idle Abort
.step
    valve = T < burn and S == Fill

[Idle]
.step
    p > 5: -> Fill
[Fill]
.step
    p > most and roll_max(p, 1 s) > 99: -> Abort
    T >= burn: -> Done
[Done]
[Abort] @abort
.entry
    valve = false
-- a.ss --
[all_states]
G == 20: p = 6
G == 60: p = 60
[Abort]
T > 100: @stop
-- b.ss --
[all_states]
G == 60: stop = true
[Abort]
T > 100: @stop
-- stdout --
  Transitions          5
  Step                 20 ms
  Unit of time         ms
  Transitions covered  3 of 5
In all states
-------------

These statements belong to several states. In each step they run before the statements of the
state's own `.step`, in the order of the file. A transition ends the step.

All states except `Abort`
The operator's button, and what the sensors report.
in every phase

  In each step, the machine
    - goes to `Abort` if `stop`
      # let go
    - if `high`:
      - sets `why` to `2`
        # 2: pressure
      - goes to `Abort`

All states except `Idle` and `Abort`
  In each step, the machine
    - sets `valve` to `T < burn and S == Fill`

States
------

The machine runs in steps. In each step it executes the statements of its state from top to bottom,
also in the step in which it enters the state. The first transition whose condition is true is
taken, and the statements after it are skipped. The next step runs the state to which the
transition leads. `T` is the time since the machine entered the state, `G` is the time.

1. Idle [initial state]
2. Fill
Each step begins with the statements of "all states except `Abort`" and "all states except `Idle`
and `Abort`".

  In each step, the machine
    - goes to `Abort` if `p > most and roll_max(p, 1 s) > 99`
    - goes to `Done` if `T >= burn`

Entered from `Idle`.

3. Done
Each step begins with the statements of "all states except `Abort`" and "all states except `Idle`
and `Abort`".

This state has no statements of its own.

Entered from `Fill`.

4. Abort [abort]
The statements of "all states except `Abort`" and "all states except `Idle` and `Abort`" do not run
in this state.

  On entry, the machine
    - sets `valve` to `false`

Entered from `Fill` and all states except `Abort`.

Transitions
-----------

If several can be taken in one step, the machine takes the first of them: those in `.entry`, then
those of all states, then those in the state's own `.step`, each in the order of the file.

  No.  From                     To     Condition                           Block  Line  Remark  Comment
    1  all states except Abort  Abort  stop                                .step    23  abort   let go
    2  all states except Abort  Abort  high                                .step    27  abort
    3  Idle                     Fill   p > 5                               .step    36
    4  Fill                     Abort  p > most and roll_max(p, 1 s) > 99  .step    39  abort
    5  Fill                     Done   T >= burn                           .step    40

Inputs, outputs and parameters
  Definition  Expression                Comment                                  Used in                                 Line
  slow        40 ms                                                              high                                      14
  most        50                        Above this the relief valve opens.; bar  high, Fill                                16
  high        roll_min(p, slow) > most                                           all states except Abort                   17
  burn        1.5 s                                                              all states except Idle and Abort, Fill    18

Rolling statistics
Every window takes a sample at the start of every step, in every state. Until it is full, its
statistic covers the samples taken so far.

  Call               Meaning                                             Steps  Line
  roll_min(p, slow)  the smallest of `p` over the last 40 ms, 3 samples      3    17
  roll_max(p, 1 s)   the largest of `p` over the last 1 s, 51 samples       51    39

What must never happen, and how we know
and what to do. Time advances by 20 ms per step, as the machine declares.
Transitions that lead to an abort state
"Unbounded": every path from the target state leads to an abort state, but before that the machine
can wait for a condition that may never become true.

  State                    To     Condition                           Reads                Worst-case steps             Line
  all states except Abort  Abort  stop                                a switch or command  1 (20 ms)                      23
  all states except Abort  Abort  high                                `p`                  1 (20 ms), after its window    27
  Idle                     Fill   p > 5                               `p`                  unbounded                      36
  Fill                     Abort  p > most and roll_max(p, 1 s) > 99  `p`                  1 (20 ms), after its window    39
  Fill                     Done   T >= burn                           time                 unbounded                      40

What was tested, and what was not
Transitions taken by the scripts
  From                     To     Times  Remark
  Idle                     Fill       1
  Fill                     Abort      0  never taken
  Fill                     Done       0  never taken
  all states except Abort  Abort      2  in Idle and Fill; 2 transitions

Not covered by the scripts
No script visits `Done`. No script takes a transition from `Fill` to `Abort` and from `Fill` to
`Done`.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places       Covered  Of  Impossible
  transitions        3   9           0
  statements        11  13           0
  guards             9  12           0
  conditions        10  16           0
  windows            1   2           0
  states             5   7           0

  Line  Not covered
    23  `-> Abort` was never taken from Fill
    27  `-> Abort` was never taken from Idle
    32  `T < burn and S == Fill` was never false
    39  `p > most and roll_max(p, 1 s) > 99` was never true
    39  `p > most` was never false while it decided
    39  `roll_max(p, 1 s)` was never full when its value mattered
    40  `T >= burn` was never true
    41  state Done was never entered

a.ss [passed]
