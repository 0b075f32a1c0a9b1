spec 4.16  With a mark in the state vector file, an element without one is no command.
warn no-all abort-by-command

-- app.sv --
[R]
U64 G
U32 S
bool stop @command
bool limitSwitch
bool valve

-- app.sm --
[state_vector]
U64 G
U32 S
bool stop
bool limitSwitch
bool valve

[Burn]
.entry
    valve = true
.step
    limitSwitch: -> Abort
    T > 3000: -> Hold

[Hold]                   #! W0905 'Hold' drives an output and can abort only by a command
.step
    stop: -> Abort
    T > 3000: -> Done

[Done] @safe
.entry
    valve = false

[Abort] @abort @safe
.entry
    valve = false
