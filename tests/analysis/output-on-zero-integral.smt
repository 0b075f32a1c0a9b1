# A machine that integrates a reading changes in every step until its backup timer ends.
warn no-all output-on-zero

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
F64  accel   @read_only @range -100 200
F64  height  @read_only @range -100 9000
F64  battery @read_only @range 0 15
bool drogue
F64  speed

[local]
F64 peak = 0

[Pad] @safe
.step
    battery < 5 and T > 1 s: -> Abort
    held(accel > 20, 200 ms): -> Boost                                  #! W0903 'accel' alone switches on 'drogue' when it reads 200

[Boost]
.entry
    speed = 0
.step
    speed = speed + accel * 0.01
    T > 1 s and accel < 2: -> Coast
    T > 8 s: -> Coast

[Coast]
.entry
    peak = height
.step
    speed = speed + accel * 0.01
    peak = max(peak, height)
    200 < height < peak - 30 and speed < 0: -> Drogue
    T > 20 s: -> Drogue

[Drogue] @safe
.entry
    drogue = true

[Abort] @abort @safe
.entry
    drogue = false
