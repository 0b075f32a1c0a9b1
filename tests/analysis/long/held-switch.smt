# States behind a switch that is held for 3 s while several sensors are good: a search reaches them, and trial runs begin along its runs. A state
# that one altimeter alone can abort is not said to be blind: the other one is alive only while its readings move.
warn no-all not-tried abort-blind

-- app.sm --
[options]
step 10 ms

[state_vector]
U64   time       @alias G
U32   state      @alias S
F32   alt1       @read_only @range -100 12000
F32   alt2       @read_only @range -100 12000
F32   accel      @read_only @range -200 400
F32   battery    @read_only @range 5 14
bool  arm        @read_only @command
bool  fuse1      @read_only
bool  fuse2      @read_only
bool  drogue

[local]
U64   liftoff = 0
F64   peak = 0

[define]
push = roll_median(accel, 5)
ok1 = alt1 != 0 and roll_range(alt1, 1 s) > 0
ok2 = alt2 != 0 and roll_range(alt2, 1 s) > 0
onPad = (ok1 or ok2) and (not ok1 or abs(alt1) < 40) and (not ok2 or abs(alt2) < 40) and 5 < push < 15
canArm = onPad and 7 < battery <= 14 and fuse1 and fuse2
onGround = (ok1 or ok2) and (not ok1 or abs(alt1) < 35) and (not ok2 or abs(alt2) < 35)

[Pad] @safe
.step
    T >= 3 s and held(arm and canArm, 3 s): -> Armed

[Armed] @safe
.step
    held(push > 25, 250 ms): -> Coast
    held(not arm, 500 ms): -> Pad

[Coast]                              #! W0930 everything: not every failure of 'alt1' was tried in 'Coast'
.entry
    liftoff = G
    drogue = true
.step
    ok1: peak = max(peak, alt1)
    G - liftoff >= 5 s and onGround: -> Abort
    G - liftoff >= 8 s or T > 2 s and held(ok1 and alt1 < peak - 5, 500 ms): -> Down

[Abort] @abort @safe
.entry
    drogue = false
.step
    held(not arm, 1 s): -> Pad

[Down] @safe
.entry
    drogue = false
.step
    T >= 10 s and held(roll_range(alt1, 1 s) < 3, 10 s): -> Pad
