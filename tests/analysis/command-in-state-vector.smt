spec 5.54  A mark in the state vector file counts in every machine that lists the element.
warn no-all abort-by-command
-- app.sv --
[R]
U64 G
U32 S
F64 stick @command
bool valve
-- app.sm --
[state_vector]
U64 G
U32 S
F64 stick
bool valve
[Burn]                    #! W0905
.entry
    valve = true
.step
    stick > 2: -> Abort
    T > 3000: -> Abort2
[Abort2] @safe
.entry
    valve = false
[Abort] @abort @safe
.entry
    valve = false
