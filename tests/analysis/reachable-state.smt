spec 5.29   States to which a transition leads that can be made, however that is known.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
U8 cmd
[local]
U8 mode = 0
U8 tries = 0
[Idle]
.step
    p > 1: mode = 2
    mode == 2: -> Abort
    p < 0 {
        tries = tries + 1
        tries > 3: -> Run
    }
    cmd == 1: -> Wait
    cmd == 2: -> Run
[Wait]
.step
    T > 100: -> Once
[Once]
.entry
    p > 4: -> Run
    else: -> Idle
[Run]
.step
    -> Run
[Abort]
