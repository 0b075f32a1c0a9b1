spec 4.16  Without any mark, every bool that the machine only reads is a command.
warn no-all abort-by-command

-- app.sm --
[state_vector]
U64 G
U32 S
bool limitSwitch
bool valve

[Burn]                   #! W0905
.entry
    valve = true
.step
    limitSwitch: -> Abort
    T > 3000: -> Done

[Done] @safe
.entry
    valve = false

[Abort] @abort @safe
.entry
    valve = false
