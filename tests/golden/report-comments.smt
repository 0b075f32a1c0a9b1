# Comments after statements, each once; the watched elements are those that are read; the steps of paths to abort states, and why some states have none.
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
The machine has 3 states and starts in `Full`. It reads `level` and `key`. It writes `valve`. It
never leaves `Abort`.

...
1. Full [initial state]
The tank is full.

  In each step, the machine
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
    - goes to `Hold` if `level > 95 or level < 0`
      # nearly over
      # or no sensor
      # only this
    - goes to `Abort` if `bad > 3`
      # three in a row
    - goes to `Hold` if `key`
      # said once
    - otherwise: sets `valve` to `false`
    - goes to `Abort` if `T > 1800000`
      # half an hour

2. Hold
  In each step, the machine
    - goes to `Abort` if `key`

Entered from `Full`.

3. Abort [abort, safe to stay]
  On entry, the machine
    - sets `valve` to `false`

Entered from `Full` and `Hold`.

Transitions
-----------

In the order of the file, which is their priority: if several can be taken in one step, the machine
takes the first of them.

  No.  From  To     Condition                Block  Line  Remark  Comment
    1  Full  Hold   level > 95 or level < 0  .step    27          only this
    2  Full  Abort  bad > 3                  .step    29  abort   three in a row
    3  Full  Hold   key                      .step    30          said once
    4  Full  Abort  T > 1800000              .step    31  abort   half an hour
    5  Hold  Abort  key                      .step    35  abort

...
Abort matrix
------------

From which states the machine can abort, and whether it still can if one sensor is dead, stuck or
out of range: with commands, and without. The steps are the worst case, from the step in which a
condition becomes true to the first step of the abort state. They do not include the time until the
condition is true: "after `held`" and "after its window" mark conditions that `held` or a rolling
statistic delays. A counter or a timer delays its condition, too.

  State  Can it abort?      Without a command?  Worst-case steps
  Full   yes                yes                 1
  Hold   yes                no                  1
  Abort  is an abort state

What each state aborts on
The variables that the guards of aborts read. A state that has no `yes` where most others have one
does not abort on that. Compare it with what the state must do.

  State  key  bad  time (T)
  Full   -    yes  yes
  Hold   yes  -    -

Transitions that lead to an abort state
"Unbounded": every path from the target state leads to an abort state, but before that the machine
can wait for a condition that may never become true.

  State  To     Condition                Reads                Worst-case steps  Line
  Full   Hold   level > 95 or level < 0  `level`              unbounded           27
  Full   Abort  bad > 3                  `level`              1                   29
  Full   Hold   key                      a switch or command  unbounded           30
  Full   Abort  T > 1800000              time                 1                   31
  Hold   Abort  key                      a switch or command  1                   35

...
