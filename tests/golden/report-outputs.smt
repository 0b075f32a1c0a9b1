# What each output is while the machine stays in a state: a constant, what earlier states have left, or an expression.  An assignment just
# before a transition, or in .exit, is no value of the state that it leaves.
args report app.sm --format=text

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F32  p      @read_only @range 0 100
bool go     @read_only @command
bool valve
bool vent
F32  drive
U8   reason
bool lamp

[all_states] @except Abort
.step
p > 90 {
    reason = 3
    -> Abort
}

[Idle] @safe
.entry
    valve = false
    drive = 0
    reason = 0
.step
    go: -> Fill
.exit
    lamp = true

[Fill]
.entry
    valve = true
.step
    p > 50: vent = true
    else if p < 40: vent = false
    drive = p / 100
    T > 5 s: -> Pass

[Pass]
.step
    -> Hold

[Hold] @safe
.step
    not go: -> Idle

[Abort] @abort @safe
.entry
    valve = false
    vent = true

[Never]
.step
    -> Idle
-- stdout --
...
Outputs in each state
---------------------

What each output is after a step in which the machine stays in the state. Several values: which one
depends on conditions or on the path to the state. An expression: the step computes the output from
it; parts that the state decides are left out. "Computed": from more than fits here, or in an
earlier step. "Unchanged": the state does not assign it, so it is what earlier states have left.
"Initial": no state has assigned it yet. Other machines, or a `[start]`, can set other values.

  State  Mark         valve              vent                                   drive                reason          lamp
  Idle   safe         `false`            unchanged: `false`, `true` or initial  `0`                  `0`             unchanged: `true` or initial
  Fill                `true`             `false`, `true` or initial             `p / 100`            unchanged: `0`  unchanged: `true`
  Pass                leaves at once     leaves at once                         leaves at once       leaves at once  leaves at once
  Hold   safe         unchanged: `true`  unchanged: `false`, `true` or initial  unchanged: computed  unchanged: `0`  unchanged: `true`
  Abort  abort, safe  `false`            `true`                                 unchanged: computed  unchanged: `3`  unchanged: `true`
  Never               never reached      never reached                          never reached        never reached   never reached

In all states
...
