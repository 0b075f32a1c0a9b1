# Outputs that a state leaves under a guard: if the guard of the transition implies it, the next state has only the value of that branch.
args report o.sm --format=text

-- o.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
bool go    @read_only
bool reset @read_only
bool valve
bool vent
bool lamp

[Idle] @safe
.entry
    valve = false
    vent = false
    lamp = false
.step
    go: -> Hot

[Hot] @abort @safe
.entry
    valve = true
    lamp = true
.step
    if T >= 5 s {
        vent = false
    } else {
        vent = true
    }
    T >= 4 s: lamp = false
    T >= 5 s: valve = false
    T >= 5 s and rising(reset): -> Safe
    T >= 4 s and go: -> Late

[Safe] @safe
.step
    go: -> Idle

[Late] @safe
.step
    T > 1 s: -> Idle
-- stdout --
...
Outputs in each state
---------------------

What each output is after a step in which the machine stays in the state. Several values: which one
depends on conditions or on the path to the state. An expression: the step computes the output from
it; parts that the state decides are left out. "Computed": from more than fits here, or in an
earlier step. "Unchanged": the state does not assign it, so it is what earlier states have left.
"Initial": no state has assigned it yet. Other machines, or a `[start]`, can set other values.

  State  Mark         valve                         vent                          lamp
  Idle   safe         `false`                       `false`                       `false`
  Hot    abort, safe  `false` or `true`             `false` or `true`             `false` or `true`
  Safe   safe         unchanged: `false`            unchanged: `false` or `true`  unchanged: `false`
  Late   safe         unchanged: `false` or `true`  unchanged: `false` or `true`  unchanged: `false` or `true`

States
...
