# A diagram has a node for each section [all_states], apart from the states, with one edge to each target. Its count is the sum over the
# states; Fill has a transition of its own to Abort, so which was taken there is unknown.
args graph a.sm a.ss b.ss --format=dot | grep -e '->' -e all
args graph a.sm a.ss b.ss --format=mermaid | grep -e '-->' -e all
args graph a.sm --format=svg | grep -e 'all states' -e '<desc>'

-- a.sm --
# Fills a tank.
[options]
step 20 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool stop @read_only
bool valve
U8 why

[define]
slow = 40 ms
# Above this the relief valve opens.
most = 50                              # bar
high = roll_min(p, slow) > most
burn = 1.5 s

# The operator's button, and what the sensors report.
[all_states] @except Abort             # in every phase
.step
    stop: -> Abort                     # let go
    high {
        # 2: pressure
        why = 2
        -> Abort
    }

[all_states] @except Idle Abort
.step
    valve = T < burn and S == Fill

[Idle]
.step
    p > 5: -> Fill
[Fill]
.step
    p > most and roll_max(p, 1 s) > 99: -> Abort
    T >= burn: -> Done
[Done]
[Abort] @abort
.entry
    valve = false
-- a.ss --
[all_states]
G == 20: p = 6
G == 60: p = 60
[Abort]
T > 100: @stop
-- b.ss --
[all_states]
G == 60: stop = true
[Abort]
T > 100: @stop
-- stdout --
    "/start" -> "Idle";
    "/all1" [label="all states except Abort", style="filled", shape=box3d];
    "/all2" [label="all states except Idle and Abort\nstep valve = T < burn and S == Fill\l", style="filled", shape=box3d];
    "Idle" -> "Fill" [label="p > 5\ntaken once"];
    "Fill" -> "Abort" [label="p > most and roll_max(p, 1 s) > 99\nnever taken", style=dotted];
    "Fill" -> "Done" [label="T >= burn\nnever taken", style=dotted];
    "/all1" -> "Abort" [label="stop\nor\nhigh\ntogether: taken 2 times"];
    classDef all fill:#fff,stroke:#46566b,stroke-width:4px,color:#1c2430,font-style:italic
    state "all states except Abort" as s5
    state "all states except Idle and Abort" as s6
    [*] --> s1
    s1 --> s2 : p #62; 5 (taken once)
    s2 --> s4 : p #62; most and roll_max(p, 1 s) #62; 99 (never taken)
    s2 --> s3 : T #62;= burn (never taken)
    s5 --> s4 : stop
    s5 --> s4 : high (together: taken 2 times)
    class s5 all
    class s6 all
<desc>4 states, 5 transitions. The initial state is Idle.</desc>
<g class="g-edge"><title>all states except Abort to Abort: stop
<g class="g-node g-all"><title>[all_states]: all states except Abort</title><rect class="g-box g-state" x="341" y="130" width="200" height="34" rx="0"/><rect class="g-box g-state" x="338" y="133" width="200" height="34" rx="0"/><rect class="g-box g-state" x="335" y="136" width="200" height="34" rx="0"/><text class="g-name" x="435" y="158">all states except Abort</text></g>
<g class="g-node g-all"><title>[all_states]: all states except Idle and Abort</title><rect class="g-box g-state" x="153" y="373" width="264" height="56" rx="0"/><rect class="g-box g-state" x="150" y="376" width="264" height="56" rx="0"/><rect class="g-box g-state" x="147" y="379" width="264" height="56" rx="0"/><text class="g-name" x="279" y="401">all states except Idle and Abort</text><path class="g-rule" d="M160 409h238"/><text class="g-block" x="160" y="424">step</text><text class="g-guard" x="194" y="424">valve = T &lt; burn and S == Fill</text></g>
