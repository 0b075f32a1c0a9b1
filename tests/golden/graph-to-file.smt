# With -o the diagram goes to a file.
args graph --format=mermaid tank.sm -o tank.mmd && cat tank.mmd
args graph tank.sm -otank.svg && ls

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stdout --
stateDiagram-v2
    %% drawn by smc
    classDef abort fill:#fdeae4,stroke:#b5320f,stroke-width:3px,color:#1c2430
    classDef safe fill:#e3f3f1,stroke:#0c7268,stroke-width:3px,color:#1c2430
    classDef all fill:#fff,stroke:#46566b,stroke-width:4px,color:#1c2430,font-style:italic
    classDef never stroke-dasharray:5
    classDef unrun stroke-dasharray:1
    state "Idle" as s1
    [*] --> s1
tank.mmd
tank.sm
tank.svg
