# States that drive an output and cannot abort, where others can.
warn no-all abort-missing
-- app.sm --
[state_vector]
U64  G
U32  S
bool go @read_only @command
F32  p  @read_only
bool valve
bool clamps
U8   shown
[Idle] @safe
.step
    go: -> Fill
[Fill]
.entry
    valve = true
    shown = 1
.step
    p > 50: -> Abort
    T > 3000: -> Release
.exit
    valve = false
[Release]                   #! W0904 'Release' drives an output and has no path to an @abort state
.entry
    clamps = true
.step
    T > 2000: -> Coast
.exit
    clamps = false
[Coast]                     # drives nothing
.step
    T > 2000: -> Mark
[Mark]                      # lasts one step
.entry
    clamps = true
.step
    -> Idle
.exit
    clamps = false
[Abort] @abort @safe
.entry
    valve = false
    shown = 9
