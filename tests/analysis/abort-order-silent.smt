# Transitions above an abort that lose nothing: the next state aborts at once ('Fill'), switches everything off itself ('Burn'), or is @safe ('Rest');
# the abort is for the cases that the transition leaves ('Settle'); it waits for time alone ('Fill'); nothing stops the next state ('Cut').
# 'Ignite' has the abort first.
warn no-all abort-order

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time     @alias G
U32  state    @alias S
bool run      @read_only @command
bool cut      @read_only @command
F32  tank     @read_only @range 0.5 60
F32  level    @read_only @range 0 100
bool fill
bool igniter
bool charge
bool fan
U8   tops

[define]
high = roll_min(tank, 3) > 45

[Idle] @safe
.step
    run: -> Fill

[Fill]
.entry
    fill = true
    tops = tops + 1
.step
    level > 90: -> Settle
    high: -> Abort
    T > 60 s: -> Abort
.exit
    fill = false

[Settle]
.step
    high: -> Abort
    level < 80 and tops < 3: -> Fill
    level < 80: -> Abort
    T > 5 s: -> Ignite

[Ignite]
.entry
    igniter = true
.step
    high: -> Abort
    cut: -> Cut
    T > 1 s: -> Burn

[Burn]
.step
    T > 3 s: -> Shutdown
    cut: -> Cut
    high: -> Abort

[Shutdown]
.entry
    igniter = false
.step
    T > 1 s: -> Vent
    level > 99: -> Abort

[Vent]
.step
    cut: -> Rest
    high: -> Abort

[Rest] @safe
.entry
    fan = true
.step
    level > 99: -> Abort

[Cut]
.entry
    charge = true
.step
    T > 10 s: -> Rest
.exit
    charge = false

[Abort] @abort @safe
.entry
    fill = false
    fan = false
    igniter = false
