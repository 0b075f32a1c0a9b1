# A window that samples another one, or a held that does: a failed run lasts until both contain only readings of the stuck sensor.
warn no-all output-on-zero

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F32  alt   @read_only @range -100 5000
bool arm   @read_only @command
bool chute

[Pad] @safe
.entry
    chute = false
.step
    arm: -> Boost

[Boost]
.step
    T > 20 s: -> Coast

[Coast]
.step
    held(roll_range(alt, 10) < 0.5, 200 ms): -> Descent                    #! W0903 'alt' alone switches on 'chute' when it sticks
    T > 60 s: -> Pad

[Descent] @safe
.entry
    chute = true
.step
    T > 5 s: -> Pad
