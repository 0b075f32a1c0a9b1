# A dead sensor brings the machine to rest in Idle; what Idle does then is a finding of Idle.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  p  @read_only
bool run @read_only @command
bool valve
[Idle] @safe
.step
    run and p < 5: -> Fill          #! W0903 'p' alone switches on 'valve' when it reads 0
[Fill]
.entry
    valve = true
.step
    p > 30: -> Hold
    T > 9000: -> Idle
.exit
    valve = false
[Hold]
.step
    p < 20: -> Idle
    T > 90000: -> Idle
