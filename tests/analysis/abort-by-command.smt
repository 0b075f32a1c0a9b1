# States that drive an output and abort only when a person says so; marked with @command, or a bool without a mark.
warn no-all abort-by-command
-- app.sm --
[state_vector]
U64  G
U32  S
bool go    @read_only @command
bool stop  @read_only @command
U8   order @read_only @command
F32  p     @read_only
bool valve
[local]
U8   code = 0
[Idle] @safe
.entry
    code = 0
.step
    go: -> Fill
[Fill]                      #! W0905 'Fill' drives an output and can abort only by a command
.entry
    valve = true
.step
    stop or order > 2: -> Abort
    T > 3000: -> Burn
[Burn]                      # through a code
.step
    if stop: code = 1
    else if p > 50: code = 2
    code > 0: -> Abort
    T > 3000: -> Shut
[Shut]                      #! W0905
.step
    if stop: code = 1
    code > 0: -> Abort
    T > 3000: -> Idle
.exit
    valve = false
[Abort] @abort @safe
.entry
    valve = false
.step
    T > 1000 and go: -> Idle
