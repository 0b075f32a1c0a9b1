# What has been found is marked in the diagram, and said as ever.
args graph --format=mermaid tank.sm

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
    state "Lost" as s5
    s2 : entry valve = true
    s2 : exit valve = false
    [*] --> s1
    s1 --> s2 : armed
    s2 --> s3 : pressure #62; 800 or pressure #60; 1
    s2 --> s3 : T #62; 60000
    s2 --> s4 : pressure #62; 500 and armed
    s2 --> s2 : pressure == 499
    s3 --> s1 : 1 #62; 2 (never)
    s5 --> s1 : on entry (never)
    class s3 abort
    class s4 safe
    class s5 never
    note right of s5 : W0503 state #39;Lost#39; is unreachable
-- stderr --
tank.sm:24:2: warning: state 'Lost' is unreachable [W0503 unreachable-state]
   24 | [Lost]
      |  ^~~~ no transition leads here: write -> Lost below a condition of another state
1 warning
