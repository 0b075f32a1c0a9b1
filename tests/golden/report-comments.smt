# Comments behind statements, each once; what is watched is what is read; what the steps of ways to abort are, and why some have none.
# steps are and why some are not bounded.
args report stand.sm -o stand.txt && cat stand.txt

-- stand.sm --
[state_vector]
U64   time    @alias G
U32   S
F32   level   @read_only
F32   spare   @read_only            # not wired yet
bool  key     @read_only            # a switch on the desk
bool  valve

[local]
U32  bad = 0

[Full]   # The tank is full.
.step
    # Counted.
    if level > 90 {          # too full
        # one more
        bad = bad + 1        # of three
        valve = true
    } else {                 # all is well
        # from the start
        bad = 0              # again
        valve = false
    }
    (level > 95              # nearly over
        or level < 0)        # or no sensor
    {
        -> Hold              # only this
    }
    bad > 3: -> Abort        # three in a row
    key: -> Hold else: valve = false     # said once
    T > 1800000: -> Abort    # half an hour

[Hold]
.step
    key: -> Abort

[Abort] @abort @safe
.entry
    valve = false
-- stdout --
...
The machine has 3 states and begins in `Full`. It watches `level` and `key`. It drives `valve`.
Once in `Abort`, it stays there.

...
1. Full [begins here]
The tank is full.

  At each step, it
    - if `level > 90`:
      # Counted.
      # too full
      - adds `1` to `bad`
        # one more
        # of three
      - sets `valve` to `true`
    - otherwise:
      # all is well
      - sets `bad` to `0`
        # from the start
        # again
      - sets `valve` to `false`
    - leaves for `Hold` if `level > 95 or level < 0`
      # nearly over
      # or no sensor
      # only this
    - leaves for `Abort` if `bad > 3`
      # three in a row
    - leaves for `Hold` if `key`
      # said once
    - otherwise: sets `valve` to `false`
    - leaves for `Abort` if `T > 1800000`
      # half an hour

2. Hold
  At each step, it
    - leaves for `Abort` if `key`

Entered from `Full`.

3. Abort [abort, safe to stay]
  When it enters, it
    - sets `valve` to `false`

Entered from `Full` and `Hold`.

Transitions
-----------

In the order of the file. Of two that could be made in one step, the upper one is made.

  No.  From  To     When                     In     Line  Remark  What its author wrote
    1  Full  Hold   level > 95 or level < 0  .step    27          only this
    2  Full  Abort  bad > 3                  .step    29  abort   three in a row
    3  Full  Hold   key                      .step    30          said once
    4  Full  Abort  T > 1800000              .step    31  abort   half an hour
    5  Hold  Abort  key                      .step    35  abort

...
Abort matrix
------------

From which states the machine can abort, and whether it still can when one sensor is dead, sticks,
or leaves its range: with people who give commands, and without. Steps are those at worst, from the
one in which the condition holds to the first in the abort state. How long a counter, a timer or a
rolling statistic takes until its condition holds comes before, and is not counted.

  State  Can it abort?         Without a command?  Steps, once a condition holds
  Full   yes                   yes                 1
  Hold   yes                   no                  1
  Abort  it is an abort state

The ways to abort
"Not bounded": from the state that such a way leads to, the machine can go nowhere but to an abort
state, but may first wait there, or on the way, for something that need not come.

  State  To     When                     Watches              Steps, once it holds  Line
  Full   Hold   level > 95 or level < 0  `level`              not bounded             27
  Full   Abort  bad > 3                  `level`              1                       29
  Full   Hold   key                      a switch or command  not bounded             30
  Full   Abort  T > 1800000              time                 1                       31
  Hold   Abort  key                      a switch or command  1                       35

...
