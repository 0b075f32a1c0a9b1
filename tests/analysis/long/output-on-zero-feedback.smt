# Trials of a failed sensor go on as the run that led to the state: a feedback follows its valve, and a counter goes on. With constant inputs an abort
# would end each state before the sensor fails.
warn no-all output-on-zero

-- app.sm --
[options]
step 10 ms

[state_vector]
U64   time       @alias G
U32   state      @alias S
F32   pA         @read_only @range 0.5 70
F32   pB         @read_only @range 0.5 70
F32   flow       @read_only @range 0 5
bool  open       @read_only
bool  arm        @read_only @command
bool  start      @read_only @command
bool  abort      @read_only @command
U32   heartbeat  @read_only
bool  valve
bool  press
U8    code

[local]
F64   filled = 0

[define]
isHigh = held(max(pA, pB) > 60, 30 ms)
isPair = held(abs(pA - pB) > 4, 100 ms)
isDead = held(min(pA, pB) < 0.4, 100 ms)
isLost = held(heartbeat == prev(heartbeat), 1 s)
isUnfed = held(valve != open, 190 ms)
isCold = held(min(pA, pB) < 5, 30 ms) and S == Burn

[all_states]
.step
    valve = S == Fill or S == Burn
    press = S == Ready or S == Burn

[all_states] @except Safe Abort
.step
    if abort or not arm: code = 1
    else if isHigh:      code = 2
    else if isCold:      code = 3
    else if isUnfed:     code = 4
    else if isPair:      code = 5
    else if isDead:      code = 6
    else if isLost:      code = 7
    code != 0: -> Abort

[Safe] @safe
.entry
    code = 0
    filled = 0
.step
    rising(arm) and not abort: -> Checks

[Checks]
.step
    T >= 3 s and held(max(pA, pB) < 2, 1 s): -> Fill
    T >= 5 s: -> Abort

[Fill]
.step
    filled = filled + flow * 0.01
    filled >= 4: -> Ready            #! W0903 'flow' alone switches on 'press' when it reads 5
    T >= 60 s: -> Abort

[Ready]
.step
    rising(start): -> Burn
    T >= 10 min: -> Abort

[Burn]
.step
    T >= 8 s: -> Last

[Last]
.step
    T >= 3 s: -> Safe

[Abort] @abort
.step
    T >= 1 s: -> Safe
