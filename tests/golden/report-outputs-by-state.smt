# Outputs that a section [all_states] computes from S: in each state what S leaves of the expression, or the constant.
args report o.sm --format=text

-- o.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
bool go  @read_only
F32  pc  @read_only
bool valve
bool vent
bool lamp
bool horn
F32  drive
F32  peak

[define]
isPulse = T - 100 * floor(T / 100) < 50

[all_states]
.step
    valve = S == Fill or S == Hold and go
    vent  = (S == Idle or S == Hold and T < 300 ms) and isPulse and not valve
    lamp  = not (S == Idle or S == Fill and pc > 3)
    horn  = (go or S == Fill or pc > 5) and (S != Idle or pc > 9)
    drive = pc * 2
    S == Hold and pc > peak: peak = pc

[Idle] @safe
.step
    go: -> Fill

[Fill]
.entry
    peak = pc
.step
    T > 5 s: -> Hold

[Hold]
.step
    drive = min(pc, 1) + min(pc, 2) + min(pc, 3) + min(pc, 4) + min(pc, 5)
    not go: -> Idle
-- stdout --
...
Outputs in each state
---------------------

What each output is after a step in which the machine stays in the state. Several values: which one
depends on conditions or on the path to the state. An expression: the step computes the output from
it; parts that the state decides are left out. "Computed": from more than fits here, or in an
earlier step. "Unchanged": the state does not assign it, so it is what earlier states have left.
"Initial": no state has assigned it yet. Other machines, or a `[start]`, can set other values.

  State  Mark  valve    vent                                    lamp            horn                         drive     peak
  Idle   safe  `false`  `isPulse and not valve`                 `false`         `(go or pc > 5) and pc > 9`  `pc * 2`  unchanged: computed
  Fill         `true`   `false`                                 `not (pc > 3)`  `true`                       `pc * 2`  computed
  Hold         `go`     `T < 300 ms and isPulse and not valve`  `true`          `go or pc > 5`               computed  computed

In all states
...
