# A limit to the sum of two states that begins again in one of them; not that of one phase, and not those that only the start resets.
warn no-all restarted-timer

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool valve
[local]
U32 steps = 0
U64 since = 0
U32 phase = 0
U32 all = 0
U32 round = 0
[Idle] @safe
.step
    go {
        all = 0
        -> Fill
    }
[Fill]
.entry
    steps = 0                       #! W0928 'steps' begins again whenever 'Settle' leads back to 'Fill'
    since = G                       #! W0928 'since'
    phase = 0
    round = 0
    valve = true
.step
    steps = steps + 1
    phase = phase + 1
    all = all + 1
    round = round + 1
    steps > 3000: -> Stop
    G - since > 60000: -> Stop
    phase > 400: -> Stop
    all > 9000: -> Stop
    p > 52: -> Settle
[Settle]
.step
    steps = 1 + steps
    all = all + 1
    round = round + 1
    steps > 3000: -> Stop
    G - since > 60000: -> Stop
    all > 9000: -> Stop
    round > 5000: -> Stop
    p < 47: -> Fill
[Stop] @safe
.entry
    valve = false
.step
    go: -> Idle
