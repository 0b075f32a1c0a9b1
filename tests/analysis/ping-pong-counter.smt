# Counters delay each condition by a few steps: the machine flips all the same, if both conditions can be true together.  Not reported: limits
# that are separate, a blinker that counts without a sensor, and a state that waits for a time.
warn no-all ping-pong

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F32  temp  @read_only @range 0 100
F32  level @read_only @range 0 100
F32  flow  @read_only @range 0 100
bool go    @read_only @command
bool heater

[local]
U32 n = 0

[Heat]
.entry
    heater = true
    n = 0
.step
    if temp > 20: n = n + 1
    else: n = 0
    n >= 3: -> Rest                       #! W0924 flip between 'Heat' and 'Rest' again and again: one round takes 6 steps

[Rest]
.entry
    heater = false
    n = 0
.step
    if temp < 25: n = n + 1
    else: n = 0
    n >= 3: -> Heat
    go: -> Low

[Low]
.entry
    n = 0
.step
    if level > 30: n = n + 1
    else: n = 0
    n >= 3: -> High
    go: -> Flash

[High]
.entry
    n = 0
.step
    if level < 25: n = n + 1
    else: n = 0
    n >= 3: -> Low

[Flash]
.entry
    heater = true
    n = 0
.step
    n = n + 1
    n >= 5: -> Dark
    go: -> Flow

[Dark]
.entry
    heater = false
    n = 0
.step
    n = n + 1
    n >= 5: -> Flash

[Flow]
.entry
    n = 0
.step
    if flow > 20: n = n + 1
    else: n = 0
    n >= 3 and T > 50 ms: -> Stop

[Stop]
.entry
    n = 0
.step
    if flow < 25: n = n + 1
    else: n = 0
    n >= 3: -> Flow
