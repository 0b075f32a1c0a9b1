# What a window that is not full has decided is followed through flags, codes and elements to what they decide.
warn window-not-full no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
U8  code
bool valve
[local]
bool bad = false
F64  mean = 0
[Watch]
.step
    T > 0 and roll_range(p, 100) == 0: bad = true           #! W0965 'roll_range(p, 100)' has 2 of 100
    mean = roll_avg(p, 20)
    if mean > 50: code = 3                        #! W0965 'roll_avg(p, 20)' has 1 of 20
    code > 0: -> Open
    bad: -> Stop
[Open] @safe
.entry
    valve = true
[Stop] @abort @safe
