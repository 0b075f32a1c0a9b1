# late-timer is about every run, so it is quiet about a machine with an @mode: T can be any time later when it steps again.
args check steady.app -Wno-all -Wlate-timer
args check paused.app -Wno-all -Wlate-timer

-- v.sv --
[T]
U64 time
U8  mode
U32 aState
F32 line
bool valve
-- a.sm --
[state_vector]
U64 time @alias G
U32 aState @alias S
F32 line @read_only
bool valve
[Flow]
.entry
    valve = true
.step
    T > 5000 and line < 95: -> Ready
    T > 120: -> Done
.exit
    valve = false
[Ready]
.entry
    valve = false
[Done] @abort @safe
.entry
    valve = false
-- steady.app --
[options]
state_vector "v.sv"
time         time 1 ms

[main]
every 50 ms:
    machine a "a.sm"
-- paused.app --
[options]
state_vector "v.sv"
time         time 1 ms

[main]
every 50 ms:
    machine a "a.sm" @mode mode
-- stderr --
a.sm:10:5: warning: 'T > 5000' is never true: a time limit ends the state when T is 150 [W0918 late-timer]
   10 |     T > 5000 and line < 95: -> Ready
      |     ^~~~~~~~~~~~~~~~~~~~~~
a.sm:11:5: note: this guard ends the state, whatever else is true
1 warning
