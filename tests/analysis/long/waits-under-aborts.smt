# A stand whose aborts watch all states: a feedback that follows its valve, a counter that goes on, sensors that agree and are alive. Each wait is
# ended by an abort unless all of them are as they should be. The search reaches the last state.
warn no-all not-tried

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

[Checks]                    #! W0930 everything: not every failure of 'pA' was tried in
.step
    T >= 3 s and held(max(pA, pB) < 2, 1 s): -> Fill
    T >= 5 s: -> Abort

[Fill]
.step
    filled = filled + flow * 0.01
    filled >= 4: -> Ready
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
