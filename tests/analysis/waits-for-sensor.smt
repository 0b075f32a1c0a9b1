# States that one sensor alone can end, and those that something else ends too.
warn no-all waits-for-sensor
-- app.sm --
[state_vector]
U64  G
U32  S
F32  alt   @read_only @range -50 9000
F32  speed @read_only
bool pull  @read_only
bool go    @read_only @command
bool main
[local]
U16 low = 0
U16 n = 0
[Pad] @safe
.step
    go: -> Single
[Single]                    #! W0926 'Single' never ends while 'alt' reads
.step
    alt < 300: -> Counted
[Counted]                   #! W0926 'Counted' never ends while 'alt'
.step
    if alt < 300: low = low + 1
    else: low = 0
    low > 20: -> Still
[Still]                     #! W0926 'Still' never ends while 'alt' is noisy
.step
    roll_range(alt, 30) < 2: -> Timed
[Timed]
.step
    alt < 300: -> Second
    T > 60000: -> Second
[Second]
.step
    alt < 300: -> Wire
    speed < 5: -> Wire
[Wire]                      # a switch that the flight operates
.step
    alt < 300 or pull: -> Steps
[Steps]
.entry
    n = 0
.step
    n = n + 1
    alt < 300: -> Person
    n >= 6000: -> Person
[Person]                    #! W0926
.step
    alt < 300: -> Landed
    go: -> Landed
[Landed] @safe
