# An @allow of a finding of trial runs is called unused only if the trials have tried everything: else the finding can exist, and the advice
# to leave the @allow out would be wrong.
args check -Wflight some.sm 2>&1 | grep -o 'W0[29][13]0 [a-z-]*'
args check -Wflight all.sm 2>&1 | grep -o 'W0[29][13]0 [a-z-]*'

-- some.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F64  x     @read_only @range -10 10
F64  y     @read_only @range -10 10
bool arm   @read_only @command

[Wake] @safe @allow(ping-pong, "shown by a script")
.step
    T >= 50 ms {
        arm and (x - 3) * (x - 3) + (y - 4) * (y - 4) < 0.0001 and x + y > 7.02 and held(x > 2, 20 ms): -> Target
        -> Pad
    }

[Pad] @safe
.step
    arm: -> Wake

[Target] @safe
.step
    T > 1 s: -> Pad
-- all.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
bool arm   @read_only @command
bool lamp

[Wake] @safe @allow(ping-pong, "shown by a script")
.step
    lamp = arm
-- stdout --
W0930 not-tried
W0210 unused-allow
