# Limits that a command begins again, that another state has, or that lead to another state.
warn no-all restarted-timer

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool again @read_only @command
bool valve
[local]
U32 steps = 0
U32 safe = 0
U32 other = 0
[Fill]
.entry
    safe = 0
.step
    safe = safe + 1
    safe > 500: -> Stop
    p > 5: -> Shake
[Shake]
.entry
    steps = 0
    other = 0
    valve = true
.step
    steps = steps + 1
    safe = safe + 1
    other = other + 1
    steps > 3000: -> Stop
    safe > 500: -> Stop
    other > 20: -> Stop
    p > 60: -> Dry
    p > 52: -> Rest
[Rest]
.step
    steps = steps + 1
    other = other + 1
    steps > 3000: -> Stop
    other > 20: -> Fill
    again and p < 47: -> Shake
    p < 3: -> Fill
[Dry]
.step
    other = other + 1
    other > 20: -> Fill
    p < 40: -> Shake
[Stop] @safe
.entry
    valve = false
.step
    again: -> Fill
