# More samples cannot change what the largest and the smallest have decided; a window of one is always full; enough steps fill one.
warn window-not-full no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
[local]
U32 steps = 0
[First]
.step
    steps = steps + 1
    roll_max(p, 5) > 30: -> Wait
    not (roll_min(p, 5) > 1): -> Wait
    roll_range(p, 5) > 3: -> Wait
    roll_avg(p, 1) > 5: -> Wait
    steps > 10 and roll_avg(p, 10) > 4: -> Wait
[Wait] @safe
.entry
    valve = true
