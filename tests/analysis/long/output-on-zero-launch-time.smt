# A backup timer since lift-off, after two more states and behind an average of 25 samples. One accelerometer that fails fires it on the pad.
warn no-all output-on-zero

-- app.sm --
[options]
step 20 ms

[state_vector]
U64  time       @alias G
U32  state      @alias S
F32  a          @read_only @range -200 200
F32  p          @read_only @range 20000 110000
F32  battery    @read_only @range 0 12
bool arm        @read_only @command
bool cutoff     @read_only @command
bool drogue

[define]
mean   = roll_avg(p, 25)
height = (base - mean) / 12

[local]
F32 base   = 101325
U64 launch = 0

[Disarmed] @safe
.step
    arm and battery > 7: -> Pad

[Pad] @safe
.step
    base = mean
    cutoff: -> Abort
    not arm: -> Disarmed
    battery < 6: -> Abort
    held(a > 20, 0.2 s): -> Boost                                       #! W0903 'a' alone switches on 'drogue'

[Boost]
.entry
    launch = time
.step
    cutoff: -> Abort
    held(a < 0, 0.1 s) or T > 4 s: -> Coast

[Coast]
.step
    cutoff: -> Abort
    held(rate(p, 25) > 20, 0.5 s) and height > 50: -> Drogue
    time - launch > 28 s: -> Drogue

[Drogue] @safe
.entry
    drogue = true

[Abort] @abort @safe
.entry
    drogue = false
