# W0930 names the guard that kept the search from a state: the part that was never true, and how close a run came; else that the parts were not
# true together, or not for long enough.
args check -Wno-all -Wnot-tried app.sm
args check -Wno-all -Wnot-tried long.sm

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F64  p     @read_only @range 0 100
F64  x     @read_only @range -10 10
F64  y     @read_only
bool go    @read_only @command

[Wait] @safe
.step
    go: -> Short

[Short]
.step
    go and (x - 3) * (x - 3) + (y - 4) * (y - 4) < 0.0001 and x + y > 7.02: -> Target
    x * 2 == 7 and x * 2 == 7.001: -> Both
    T > 60 ms: -> Wait

[Target] @safe
.step
    T > 10 ms: -> After

[Both] @safe
.step
    T > 10 ms: -> Wait

[After] @safe
.step
    T > 10 ms: -> Wait

-- long.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F64  p     @read_only @range 0 100

[Wait] @safe
.step
    held(T < 1 s and p > 50, 2 s): -> Long
    p > 40 and T > 3 s: -> Wait

[Long] @safe
.step
    T > 10 ms: -> Wait
-- stderr --
app.sm:22:2: warning: trial runs have not tried everything: no run reached 'Target', 'Both', 'After' [W0930 not-tried]
   22 | [Target] @safe
      |  ^~~~~~
app.sm:18:12: note: no run reached 'Target', because '(x - 3) * (x - 3) + (y - 4) * (y - 4) < 0.0001' was never true; the closest was (x - 3) * (x - 3) + (y - 4) * (y - 4) = 0.07079
app.sm:9:6: note: 'y' has no @range: with one, trial runs also read its ends and its middle
app.sm:19:5: note: no run reached 'Both', because 'x * 2 == 7' was never true; the closest was x * 2 = 6.9998999999946445
note: trials of a state that no run reached begin with it, as if it were the first state; a script that leads there, run with 'smc faults', tries it as it is
1 warning
long.sm:14:2: warning: trial runs have not tried everything: no run reached 'Long' [W0930 not-tried]
   14 | [Long] @safe
      |  ^~~~
long.sm:11:5: note: no run reached 'Long', because 'held(T < 1 s and p > 50, 2 s)' was never true: the condition was met, but not for long enough
note: trials of a state that no run reached begin with it, as if it were the first state; a script that leads there, run with 'smc faults', tries it as it is
1 warning
