# As abort-order.smt, but nothing stops the igniter once it burns: the author has decided that.
warn no-all abort-order

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time     @alias G
U32  state    @alias S
bool run      @read_only @command
bool fire     @read_only @command
F32  tank     @read_only @range 0.5 60
F32  line     @read_only @range 60 330
bool bleed
bool igniter

[define]
low  = roll_max(tank, 5) < 30
high = roll_min(tank, 3) > 45

[Idle] @safe
.step
    run: -> Chill

[Chill]
.entry
    bleed = true
.step
    roll_max(line, 20) < 110: -> Armed        #! W0914 'Chill' goes to 'Armed' although 'high' is true in the same step
    high: -> Abort
    T > 40 s: -> Abort

[Armed]
.step
    fire: -> Ignite
    low: -> Abort
    T > 60 s: -> Abort

[Ignite]
.entry
    igniter = true
.step
    T > 2 s: -> Idle
.exit
    igniter = false
    bleed = false

[Abort] @abort @safe
.entry
    bleed = false
    igniter = false
