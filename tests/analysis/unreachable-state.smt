spec 5.29   A state that no possible transition reaches is reported once, with the reason.
warn no-constant-guard
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool cmd
[local]
U8 mode = 0
U8 test = 0 @read_only
U8 tries = 0
U8 late = 0
U8 first = 0
U8 second = 0
[Idle]
.step
    p > 1 { mode = 1 }
    else { mode = 0 }
    mode == 2: -> Abort
    tries > 3: -> Abort
    tries = 0
    test == 1: -> Bench          # a switch, set on purpose
    cmd and p > 3: -> Run
    cmd: -> Late
    p > 5 and p < 4 {
        p < 3: -> Deep
    }
[Run]
.step
    -> Idle
[Abort]                          #! W0515 'Abort'
.step
    p < 0: -> Safing
[Safing]
[Bench]
.step
    p > 3: -> BenchTwo
[BenchTwo]
[Deep]                           #! W0515 'Deep'
[Late]
.step
    late == 1: -> Idle                   # read-before-write says it
    first == 1: -> Never
    p > 3 {
        late = 1
        -> Idle
    }
    p < -3: -> Leave
[Leave]
.step
    second == 1: -> Unlikely
    p > 3: -> Idle
.exit
    cmd = false
[Unlikely]                       #! W0515 'Unlikely'
.step
    second = 1
    -> Idle
[Never]                          #! W0515 'Never'
.step
    first = 1
    -> Idle
[Lost]                           #! W0503 state 'Lost' is unreachable
.step
    p > 2: -> Loop
    p > 1: -> Run
[Loop]
.step
    -> Lost2
[Lost2]
.step
    -> Loop
[Ring]                           #! W0503 'Ring'
.step
    -> Ring2
[Ring2]
.step
    -> Ring
