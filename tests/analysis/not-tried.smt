# What trial runs did not try is one warning for the machine: a state that the search cannot reach, a state too short for its windows.
warn no-all not-tried

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F64  p     @read_only @range 0 100
F64  x     @read_only @range -10 10
F64  y     @read_only @range -10 10
bool go    @read_only @command
bool valve

[Wait] @safe
.step
    valve = false
    go: -> Short

[Short]                                                                 #! W0930 no run reached 'Target'; not every failure of 'p' was tried in 'Short'
.step
    p > 50: valve = true
    T > 50 ms and (x - 3) * (x - 3) + (y - 4) * (y - 4) < 0.0001 and x + y > 7.02: -> Target
    roll_avg(p, 100) > 60: -> Wait
    T > 60 ms: -> Wait

[Target] @safe
.step
    go: -> Wait
