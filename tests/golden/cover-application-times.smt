# smc cover of an application uses how long a state lasts at most: slow steps every 20 ms, so its state Wait begins a step at 40 ms, but no later.
args cover two.app -o made | grep -v '^wrote'

-- two.sv --
[A]
U64  time
U32  fastState
U32  slowState
bool go @command
bool hit
-- fast.sm --
[state_vector]
U64  time      @alias G
U32  fastState @alias S

[On] @safe
.step
    T > 20 ms: -> On
-- slow.sm --
[state_vector]
U64  time      @alias G
U32  slowState @alias S
bool go        @read_only
bool hit

[Wait] @safe
.step
    T >= 40 ms: hit = true
    T > 40 ms: hit = false
    T > 20 ms: -> Done

[Done] @safe
.step
    go: -> Wait
-- two.app --
[options]
state_vector "two.sv"
time time 1 ms
[flight]
every 10 ms:
    machine fast "fast.sm"
every 20 ms:
    machine slow "slow.sm"
-- stdout --
goals of fast: 9 of 9 reached
goals of slow: 27 of 27 reached, and 3 impossible
impossible in slow:
  line 10: `T > 40 ms` was never true: `T` is from 0 to 40, if only inputs change, and delta_t is 20
  2 more goals, with the same cause as one of these
