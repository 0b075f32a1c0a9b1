# Machines that were corrected as W0910 and W0914 advise: nothing is reported.  'Soak' has the abort first, 'Hold' has it below a time limit, and
# [all_states] has that of all states.
warn flight no-not-tried

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
F32  tank    @read_only @range 0.5 60
bool run     @read_only @command
bool stop    @read_only @command
bool bleed
bool feed

[define]
high = tank > 45

[all_states] @except Idle Abort Done
.step
    stop: -> Abort
    not (1 < tank < 58): -> Abort

[Idle] @safe
.entry
    bleed = false
    feed = false
.step
    run and T > 100 ms: -> Flow

[Flow]
.entry
    bleed = true
.step
    high: -> Abort
    T >= 2 s: -> Soak
    roll_range(tank, 200) == 0: -> Abort

[Soak]
.step
    high: -> Abort
    T >= 1 s: -> Feed
    roll_range(tank, 200) == 0: -> Abort

[Feed]
.entry
    feed = true
.step
    T > 3 s: -> Hold
    high: -> Abort
    roll_range(tank, 200) == 0: -> Abort

[Hold]
.step
    T > 1 s: -> Done
    high: -> Abort
    roll_range(tank, 200) == 0: -> Abort
.exit
    feed = false
    bleed = false

[Done] @safe

[Abort] @abort @safe
.entry
    bleed = false
    feed = false
