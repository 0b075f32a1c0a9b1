# Windows are taken to be full of healthy samples when a state begins again, and what each step computes is no latch.
warn no-all abort-latch
-- app.sm --
[state_vector]
U64  G
U32  S
bool key   @read_only @command
F32  a     @read_only
F32  b     @read_only
F32  c     @read_only
F32  p     @read_only @range 0 60
bool valve
[local]
F64  mid = 0
U8   runs = 0
[Idle] @safe
.step
    mid = max(min(a, b), min(max(a, b), c))
    key and T > 100: -> Prime
[Prime]
.entry
    valve = true
    runs = runs + 1
.step
    mid = max(min(a, b), min(max(a, b), c))
    roll_avg(p, 10) > 50 or runs > 200: -> Abort
    roll_min(mid, 5) > 18: -> Fire
    T > 600: -> Abort
[Fire]
.step
    mid = max(min(a, b), min(max(a, b), c))
    roll_max(mid, 3) < 8: -> Abort
    T > 5000: -> Idle
.exit
    valve = false
[Abort] @abort @safe
.entry
    valve = false
.step
    T > 20 and not key: -> Idle
