# Where a transition that a dead sensor brings about leads into a state that switches something on.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64 G
U32 S
F32 altitude @read_only @range -200 9000
F32 speed    @read_only
bool arm     @read_only
bool charge
bool lamp
[Wait]
.entry
    charge = false
    lamp = false
.step
    altitude < 250: -> Fire             #! W0903 'altitude' alone switches on 'charge' when it reads 0
    T > 500: -> Both
[Both]
.step
    altitude < 250 and speed > 3: -> Fire   # a second sensor
    T > 500: -> Plausible
[Plausible]
.step
    20 < altitude < 250: -> Fire        # 0 and the ends of the range are excluded
    T > 500: -> Anyway
[Anyway]
.step
    altitude < 250: -> Fire             #! W0903 'charge'
    T > 500 and arm: -> Fire
    T > 600: -> Lit
[Lit]
.entry
    charge = true                       # it is on already
.step
    altitude < 250: -> Fire
    T > 500: -> Done
[Fire]
.entry
    charge = true
.step
    T > 300: -> Done
[Done]
.entry
    charge = false
.step
    altitude < 100: -> Quiet            # nothing is switched on
    speed < 1: -> Abort                 # an answer
[Quiet] @safe
.step
    arm: -> Wait
[Abort] @abort
.entry
    lamp = true
.step
    arm: -> Wait
