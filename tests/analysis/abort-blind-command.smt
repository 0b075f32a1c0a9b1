# A sensor that has failed ends the state; the state that follows aborts.  A command that held the state all along holds it here.
warn no-all abort-blind

-- app.sm --
[state_vector]
U64   time       @alias G
U32   phase      @alias S
F32   tankTemp   @read_only @range 250 330
F32   pressure   @read_only @range 0 100
bool  run        @read_only @command
U8    heater
[local]
U8 code = 0
[Idle] @safe
.step
    run: -> Hold
[Hold]                      #! W0901 'pressure' reads 0 or less than 0
.step
    code = 0
    if pressure > 58: code = 1
    else if tankTemp < 283: code = 2
    not run: -> Idle
    code == 1: -> Abort
    code > 0: -> Warm
[Warm]                      #! W0901 'pressure' reads 0 or less than 0
.entry
    heater = 60
.step
    code = 0
    if pressure > 58: code = 1
    not run: -> Idle
    code > 0: -> Abort
    tankTemp > 288: -> Hold
    T > 600000: -> Hold
.exit
    heater = 0
[Abort] @abort @safe
.step
    not run: -> Idle
