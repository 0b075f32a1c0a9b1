# A second sensor that agrees, among sensors that the machine aborts by; sensors of one quantity agree with each other.
warn no-all output-on-zero
advance 20
-- app.sm --
[state_vector]
U64  G
U32  S
bool key          @read_only @command
F32  batteryA     @read_only @range 0 36
F32  batteryB     @read_only @range 0 36
F32  groundAmps   @read_only @range 0 20
F32  internalAmps @read_only @range 0 20
F32  p            @read_only
bool puller
bool valve
[Verify]
.step
    not (25 < roll_avg(batteryA, 25) < 30): -> Scrub
    not (25 < roll_avg(batteryB, 25) < 30): -> Scrub
    T >= 1000 and roll_max(groundAmps, 10) < 0.5 and roll_min(internalAmps, 10) > 2: -> Pull
    T > 30000: -> Fill
[Pull]
.entry
    puller = true
.step
    T > 1000: -> Done
.exit
    puller = false
[Fill]
.step
    abs(batteryA - batteryB) < 5 and p < 10: -> Open      #! W0903 'p' alone switches on 'valve' when it reads 0
    T > 9000: -> Done
[Open]
.entry
    valve = true
.step
    T > 1000: -> Done
.exit
    valve = false
[Done] @safe
[Scrub] @abort @safe
.step
    T > 3000 and not key: -> Verify
