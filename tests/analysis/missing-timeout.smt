# States that switch something on, and have no way out that time alone brings about.
warn no-all missing-timeout

-- app.sm --
[state_vector]
U64 G
U32 S
F32 level    @read_only
F32 longest  @read_only
bool stop    @read_only
bool valve
U8   pump                           # percent
U8   phase                          # a code: 0, 1, 2, 3
[local]
U64 since = 0
U16 steps = 0
U16 good  = 0
U64 limit = 5000 @read_only
[Idle]
.entry
    valve = false
    pump  = 0
    phase = 0
.step
    level > 1: -> Plain
[Plain]                     #! W0921 'Plain' switches 'valve' on and has no transition that time alone makes
.entry
    valve = true
.step
    level > 2: -> InStep
    stop and T > 100: -> Idle
[InStep]                    #! W0921 'pump'
.step
    level > 3: pump = 70
    level > 4: -> Sensor
[Sensor]                    #! W0921
.entry
    valve = true
.step
    T > limit and level > 5: -> Regulated
[Regulated]                 #! W0921
.step
    level > 6: valve = false
    level < 5: valve = true
    level > 7: -> GoodSteps
[GoodSteps]                 #! W0921
.entry
    valve = true
.step
    level > 3: good = good + 1
    good > 100: -> Times
[Times]
.entry
    valve = true
.step
    level > 8: -> Since
    T > limit: -> Since
[Since]                     # since when is a moment: it is left 5 s later
.entry
    since = G
    valve = true
.step
    G - since > 5000: -> Deadline
[Deadline]
.entry
    since = G + 5000
    valve = true
.step
    G >= since: -> Steps
[Steps]                     # after so many steps
.entry
    steps = 0
    valve = true
.step
    steps = steps + 1
    steps >= 200: -> Setting
[Setting]                   # after as long as it is set to
.entry
    valve = true
.step
    T > longest: -> Cut
[Cut]                       # it ends by itself
.entry
    valve = true
.step
    T > 300: valve = false
    level > 8: -> Whichever
[Whichever]                 # one or the other
.entry
    valve = true
.step
    T > 100 {
        level > 3: -> Coded
        -> Kept
    }
[Coded]                     # a code drives nothing
.entry
    valve = false
    phase = 1
.step
    level > 9: -> Off
    level > 10: phase = 2
[Off]
.entry
    valve = false
    phase = 3
.step
    level > 10: -> Kept
[Kept] @safe
.entry
    valve = true
.step
    level < 1: -> Failed
[Failed] @abort
.entry
    valve = true
.step
    stop: -> Idle
