# States from which no abort is left when a sensor reads 0 or leaves its @range.
warn no-all abort-blind

-- app.sm --
[state_vector]
U64  G
U32  S
F32  pressure @read_only @range 0.5 40
F64  thrust   @read_only
U16  level    @read_only @range 10 500
bool kill     @read_only
U8   command  @read_only
bool valve
[local]
F64  filtered = 0
F64  smooth = 0
bool over = false
bool launched = false
U8   count = 0
F64  ground = 0
F64  peak = 0
F64  scale = 0
U32  weird = 0

[Launch]
.step
    thrust > 500: launched = true
    T > 100: -> Plain
[Plain]                     #! W0901 state 'Plain' cannot abort while 'pressure' reads less than 0.5: no
.step
    pressure > 38: -> Abort
    T > 5000: -> Below
[Below]                     #! W0901 'pressure' reads more than 40
.step
    pressure < 0.5: -> Abort
    T > 5000: -> Both
[Both]                      # covers 0 and both sides
.step
    pressure > 40 or pressure < 0.5: -> Abort
    T > 5000: -> Zero
[Zero]                      #! W0901 reads 0 or more than 500
.step
    10 < level < 15: -> Abort
    level > 65000 and level < 3: -> Abort
    0 < level < 10: -> Abort
    T > 5000: -> NoRange
[NoRange]                   #! W0901 'thrust' reads 0: no
.step
    thrust > 1000 or thrust < 0: -> Abort
    T > 5000: -> Second
[Second]                    # a second sensor
.step
    thrust > 1000: -> Abort
    pressure > 40: -> Abort
    T > 5000: -> Switch
[Switch]                    #! W0901 'thrust' reads 0
# a person may not be there
.step
    thrust > 1000: -> Abort
    kill: -> Abort
    T > 5000: -> Command
[Command]                   #! W0901 'thrust' reads 0
.step
    thrust > 1000 or command == 3: -> Abort
    T > 5000: -> Timed
[Timed]                     #! W0901 'thrust' reads 0
# the limit to T comes after the state has ended
.step
    thrust > 1000 or T > 10000: -> Abort
    T > 5000: -> OnlyCommand
[OnlyCommand]               # a command is no sensor
.step
    command == 9: -> Abort
    T > 5000: -> Conjunction
[Conjunction]               # a person is needed in any case
.step
    thrust > 1000 and kill: -> Abort
    T > 5000: -> Average
[Average]                   #! W0901 'thrust' reads 0
.step
    roll_avg(thrust, 10) > 1000: -> Abort
    T > 5000: -> Stuck
[Stuck]                     # a dead sensor does not move
.step
    thrust > 1000: -> Abort
    T > 1000 and roll_range(thrust, 50) < 0.1: -> Abort
    T > 5000: -> Spread
[Spread]
.step
    thrust > 1000: -> Abort
    roll_max(thrust, 50) - roll_min(thrust, 50) < 0.1: -> Abort
    T > 5000: -> Chain
[Chain]                     #! W0901 'thrust' reads 0
.step
    thrust > 1000: -> Close
    T > 5000: -> Long
[Long]                      # the way by thrust waits: it is no way to abort at once; a switch is
.step
    thrust > 1000: -> Slow
    kill: -> Close
    T > 5000: -> SameStep
[SameStep]                  #! W0901 'thrust' reads 0
.step
    ground = thrust * 2 - 5
    ground > 1000: -> Abort
    T > 5000: -> Filtered
[Filtered]                  #! W0901 'thrust' reads 0
.step
    filtered > 1000: -> Abort
    filtered = 0.9 * filtered + 0.1 * thrust
    T > 5000: -> Smooth
[Smooth]                    # the filter comes to rest at 50
.step
    smooth > 1000 or smooth > 49: -> Abort
    smooth = smooth + 0.2 * (50 + thrust - smooth)
    T > 5000: -> SmoothHigh
[SmoothHigh]                # what the state before has left may be enough
.step
    smooth > 60: -> Abort
    T > 5000: -> Flag
[Flag]                      #! W0901 'thrust' reads 0
.step
    over: -> Abort
    thrust > 1000: over = true
    T > 5000: -> Noted
[Noted]                     # noted by an earlier state, perhaps before the sensor died
.step
    launched and thrust < 10: -> Abort
    T > 5000: -> Debounced
[Debounced]                 #! W0901 'thrust' reads 0
.step
    thrust > 1000: count = count + 1
    else: count = 0
    count > 5: -> Abort
    T > 5000: -> Peak
[Peak]                      #! W0901 'thrust' reads 0
# it can be dead from the beginning
.step
    peak = max(peak, thrust)
    thrust < peak - 50: -> Abort
    T > 5000: -> Scaled
[Scaled]                    # what the local is scaled by is not known from the begin of the block
.step
    scale = T
    weird = (thrust + 1) * scale
    T > 5000: -> Scaled2
[Scaled2]
.step
    weird > 40: -> Abort
    T > 5000: -> Away
[Away]                      #! W0901 'thrust' reads 0
# it is left, for something else than an @abort state
.step
    thrust < 5: -> Close2
    thrust > 1000: -> Abort
[Close2]
.step
    T > 5000: -> Early
[Early]                     # at 0 the state is left
.step
    level > 9: -> Entry
    thrust < 5: -> Entry
    T > 900: -> Abort
    thrust > 1000: -> Abort
[Entry]                     #! W0901 'thrust' reads 0
.entry
    thrust > 5: -> Abort
.step
    T > 5000: -> Never
[Never]                     # never fires at all: another finding's business
.step
    level > 70000: -> Abort
    T > 5000: -> Nested
[Nested]                    #! W0901 'thrust' reads 0
.step
    thrust > 10 {
        pressure > 40: -> Abort
        else if pressure < 0.5: -> Abort
    }
    T > 5000: -> Else
[Else]                      # `else` is what 0 leads to
.step
    thrust > 10: valve = true
    else: -> Abort
    T > 5000: -> None
[None]                      # demands none
.step
    T > 5000: -> Plain
[Close]
.entry
    valve = false
    -> Abort
[Slow]
.step
    T > 100: -> Abort
[Abort] @abort @safe
.step
    pressure > 38: -> Last
[Last] @abort
.entry
    valve = true
