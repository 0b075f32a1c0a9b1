# States that can abort by one sensor only, which may stick.
warn no-all abort-single-sensor

-- app.sm --
[state_vector]
U64  G
U32  S
F32  pressure @read_only @range 0.5 40
F64  thrust   @read_only
U16  level    @read_only
U16  a @read_only
U16  b @read_only
U16  c @read_only
bool kill     @read_only
U8   command  @read_only
bool valve
[local]
F64  filtered = 0
F64  last = 0
U16  same = 0
bool over = false
F64  limit = 40
F64  noted = -1
F64  most = 40 @read_only

[Decide]                    # lasts one step: nothing can stick in it
.step
    thrust > 90: -> Abort
    else: -> Both
[Both]                      #! W0902 state 'Both' cannot abort if 'pressure' sticks, for example at 20.25
.step
    pressure > 40: -> Abort
    pressure < 0.5: -> Abort
    T > 5000: -> Second
[Second]
.step
    pressure > 40: -> Abort
    thrust > 100: -> Abort
    T > 5000: -> Switch
[Switch]                    #! W0902 'pressure'
.step
    pressure > 40: -> Abort
    kill: -> Abort
    T > 5000: -> Command
[Command]                   #! W0902 'pressure'
.step
    pressure > 40: -> Abort
    command == 3: -> Abort
    T > 5000: -> Timed
[Timed]
.step
    pressure > 40 or pressure < 1: -> Abort
    T > 4000: -> Abort
    T > 3000: -> Clock
[Clock]
.step
    pressure > 40: -> Abort
    G > 4000000: -> Abort
    true: -> Late
[Late]                      #! W0902 'pressure'
.step
    T > 100 and pressure > 40: -> Abort
    T > 5000: -> Vote
[Vote]                      #! W0902 'a'
.step
    a > 40 and b > 40: -> Abort
    T > 5000: -> TwoOfThree
[TwoOfThree]
.step
    (a > 40 and b > 40) or (a > 40 and c > 40) or (b > 40 and c > 40): -> Abort
    T > 5000: -> Difference
[Difference]
.step
    abs(a - b) > 40: -> Abort
    T > 5000: -> Statistic
[Statistic]                 #! W0902 'thrust'
.step
    roll_avg(thrust, 10) > 100: -> Abort
    roll_range(thrust, 10) > 50: -> Abort
    T > 5000: -> Moves
[Moves]
.step
    thrust > 100: -> Abort
    roll_range(thrust, 10) == 0: -> Abort
    T > 5000: -> MovesToo
[MovesToo]
.step
    thrust > 100: -> Abort
    roll_max(thrust, 10) <= roll_min(thrust, 10) + 0.01: -> Abort
    T > 5000: -> MovesHigh
[MovesHigh]                 #! W0902 'thrust'
.step
    thrust > 100: -> Abort
    roll_range(thrust, 10) == 0 and thrust > 50: -> Abort
    T > 5000: -> Counter
[Counter]
.step
    thrust > 100: -> Abort
    thrust == last: same = same + 1
    else: same = 0
    last = thrust
    same > 50: -> Abort
    T > 5000: -> Filtered
[Filtered]                  #! W0902 'thrust'
.step
    filtered = 0.8 * filtered + 0.2 * thrust
    not (1 < filtered < 60): -> Abort
    T > 5000: -> Flag
[Flag]                      #! W0902 'level'
.step
    level > 900 or level < 5: over = true
    over: -> Abort
    T > 5000: -> Named
[Named]                     #! W0902 'level'
.step
    level > most or level < most - 30: -> Abort
    T > 6000: -> Chain
    T > 5000: -> Ways
[Chain]                     # the limit to T leads to an @abort state through Always
.step
    level > 50: -> Abort
    T > 5000: -> Always
[Ways]                      #! W0902 'level'
.entry
    level < 5: -> Abort
.step
    level > 50 {
        valve: -> Close
        else: -> Abort
    }
    T > 5000: -> Second
[Always]                    # cannot stay whatever it reads
.step
    level > 50: -> Abort
    else: -> Abort
[Close]
.entry
    valve = false
    -> Abort
[Abort] @abort @safe
.step
    pressure > 40: -> Second
