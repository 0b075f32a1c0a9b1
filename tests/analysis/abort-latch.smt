# What a former abort has left behind: it aborts at once, or can no longer abort.
warn no-all abort-latch
-- app.sm --
[state_vector]
U64  G
U32  S
bool key   @read_only @command
F32  p     @read_only @range 0 60
bool valve
[local]
U8   why = 0
bool reported = false
U8   fresh = 0
[Idle] @safe
.step
    key and T > 100: -> Prime
[Prime]
.entry
    valve = true
    fresh = 0
.step
    p > 45: why = 1
    p >= 0 and why > 0: -> Abort        #! W0907 when 'Prime' begins again after an abort, it aborts at once: 'why' is still 1
    p > 50: fresh = 1
    fresh > 0: -> Abort                 # set back at the beginning
    not key: -> Idle
    T > 600: -> Fire
[Fire]
.step
    p < 4 and not reported: -> Abort    #! W0908 when 'Fire' begins again, it can no longer abort: 'reported' is still 1
    T > 5000: -> Idle
.exit
    valve = false
[Abort] @abort @safe
.entry
    valve = false
    reported = true
.step
    T > 3000 and not key: -> Again
[Again] @safe
.entry
    p > 10: why = 0
.step
    key: -> Prime
    T > 100: -> Idle
