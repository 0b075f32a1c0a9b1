# With scripts after the machine, the diagram shows what their runs have covered. Several transitions from one state to another are counted
# together. A script that fails is reported, and counts up to its failure.
args graph --format=dot tank.sm tank.ss
args graph --format=mermaid tank.sm tank.ss wrong.ss
args graph tank.sm tank.ss | grep -o 'never taken\|together: taken twice\|taken once\|Dotted: [a-z ]*\|entered [a-z]*' | sort | uniq -c
args graph tank.sm broken.ss -o x.svg

-- tank.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
bool armed   @read_only
bool valve
[Idle] @safe
.step
    armed: -> Fill
[Fill]
.entry
    valve = true
.step
    pressure > 800: -> Abort
    T > 60: -> Abort
    pressure > 500 and armed: -> Done
.exit
    valve = false
[Abort] @abort @safe
[Done] @safe
-- tank.ss --
[options]
delta_t 10
[Idle]
true: armed = true
[Fill]
T == 30: pressure = 900
[Abort]
true: @stop
-- wrong.ss --
[options]
delta_t 10
[all_states]
true: armed = true
T == 20: @assert pressure > 1
T == 50: @stop
-- broken.ss --
[options]
delta_t 10
[Nowhere]
true: @stop
-- stdout --
digraph "tank" { // drawn by smc
    graph [fontname="Helvetica"];
    node [shape=box, fontname="Helvetica", color="#46566b", fillcolor="#eef3f9"];
    edge [fontname="Helvetica", fontsize=10, color="#6a7787"];
    "/start" [shape=point, width=0.15];
    "/start" -> "Idle";
    "Idle" [label="Idle\nentered once", style="filled,rounded", color="#0c7268", fillcolor="#e3f3f1", peripheries=2];
    "Fill" [label="Fill\nentered once\nentry valve = true\lexit valve = false\l", style="filled,rounded"];
    "Abort" [label="Abort\nentered once", style="filled", shape=octagon, color="#b5320f", fillcolor="#fdeae4", peripheries=2];
    "Done" [label="Done\nnever entered", style="filled,rounded,dotted", color="#0c7268", fillcolor="#e3f3f1", peripheries=2];
    "Idle" -> "Fill" [label="armed\ntaken once"];
    "Fill" -> "Abort" [label="pressure > 800\nor\nT > 60\ntogether: taken once, never by line 15"];
    "Fill" -> "Done" [label="pressure > 500 and armed\nnever taken", style=dotted];
}
stateDiagram-v2
    %% drawn by smc
    classDef abort fill:#fdeae4,stroke:#b5320f,stroke-width:3px,color:#1c2430
    classDef safe fill:#e3f3f1,stroke:#0c7268,stroke-width:3px,color:#1c2430
    classDef all fill:#fff,stroke:#46566b,stroke-width:4px,color:#1c2430,font-style:italic
    classDef never stroke-dasharray:5
    classDef unrun stroke-dasharray:1
    state "Idle" as s1
    state "Fill" as s2
    state "Abort" as s3
    state "Done" as s4
    s2 : entry valve = true
    s2 : exit valve = false
    [*] --> s1
    s1 --> s2 : armed (taken 2 times)
    s2 --> s3 : pressure #62; 800
    s2 --> s3 : T #62; 60 (together: taken once, never by line 15)
    s2 --> s4 : pressure #62; 500 and armed (never taken)
    class s1 safe
    class s3 abort
    class s4 safe
    class s4 unrun
      1 Dotted: not covered by any script
      3 entered once
      2 never taken
      4 taken once
-- stderr --
wrong.ss:5:18: error: assert failed after step 4 (G = 30, state Fill) [E0750]
    5 | T == 20: @assert pressure > 1
      |                  ^~~~~~~~~~~~ pressure = 0
note: the last steps, and the values after each:
      step   G  state  pressure
         1   0  Idle          0
         2  10  Fill          0
         3  20  Fill          0
         4  30  Fill          0
tank.sm:9:12: note: transition in step 1 (G = 0): Idle -> Fill
1 error
broken.ss:3:2: error: unknown state 'Nowhere' [E0501]
    3 | [Nowhere]
      |  ^~~~~~~
1 error
-- exit --
0 1 0 1
