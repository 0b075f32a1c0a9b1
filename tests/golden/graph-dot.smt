# The state diagram for Graphviz.
args graph --format dot tank.sm

-- tank.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
bool armed   @read_only
bool valve
[Idle]
.step
    armed: -> Fill
[Fill]
.entry
    valve = true
.step
    pressure > 800 or pressure < 1: -> Abort
    T > 60000: -> Abort
    pressure > 500 and armed: -> Done
    pressure == 499: -> Fill
.exit
    valve = false
[Abort] @abort
.step
    1 > 2: -> Idle
[Done] @safe
[Lost]
.entry
    -> Idle
-- stdout --
digraph "tank" { // drawn by smc
    graph [fontname="Helvetica"];
    node [shape=box, fontname="Helvetica", color="#46566b", fillcolor="#eef3f9"];
    edge [fontname="Helvetica", fontsize=10, color="#6a7787"];
    "/start" [shape=point, width=0.15];
    "/start" -> "Idle";
    "Idle" [label="Idle", style="filled,rounded"];
    "Fill" [label="Fill\nentry valve = true\lexit valve = false\l", style="filled,rounded"];
    "Abort" [label="Abort", style="filled", shape=octagon, color="#b5320f", fillcolor="#fdeae4"];
    "Done" [label="Done", style="filled,rounded", color="#0c7268", fillcolor="#e3f3f1", peripheries=2];
    "Lost" [label="Lost\n(W0503)", style="filled,rounded,dashed", tooltip="W0503: state 'Lost' is unreachable"];
    "Idle" -> "Fill" [label="armed"];
    "Fill" -> "Abort" [label="pressure > 800 or pressure < 1\nor\nT > 60000"];
    "Fill" -> "Done" [label="pressure > 500 and armed"];
    "Fill" -> "Fill" [label="pressure == 499"];
    "Abort" -> "Idle" [label="1 > 2", style=dashed];
    "Lost" -> "Idle" [label="on entry", style=dashed];
}
-- stderr --
tank.sm:24:2: warning: state 'Lost' is unreachable [W0503 unreachable-state]
   24 | [Lost]
      |  ^~~~ no transition leads here: write -> Lost below a condition of another state
1 warning
