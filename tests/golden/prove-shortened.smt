# A violation that only a script shows: the script below the verdict has neither the waits nor the changes that it does not need.
args prove a.sm a.rq late.ss -w --effort=1 --format=json | grep -o '"violated_by_step":[0-9]*\|"violated_after":[0-9]*,"changes":[0-9]*'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  key    @read_only
bool start  @read_only
bool lamp   @read_only
bool open

[local]
F64 a = 0
F64 b = 0

[Idle]
.step
    lamp: -> Idle
    start: -> Read

[Read]
.step
    a = a * 31 + key * key
    a = a - 65521 * floor(a / 65521)
    b = b * 57 + key * (key + 3)
    b = b - 65521 * floor(b / 65521)
    T >= 40 ms and a == 40961 and b == 41309: -> Open
    T >= 40 ms: -> Idle
.exit
    a = 0
    b = 0

[Open] @safe
.entry
    open = true
-- a.rq --
R1 "never open" never open
-- late.ss --
[all_states]
at 5 s:     lamp = true
at 6 s:     lamp = false
at 7 s:     lamp = true
at 8 s:     lamp = false
at 20 s:    start = true
at 20.01 s: key = 46535
at 20.02 s: key = 29009
at 20.03 s: key = 77
at 20.04 s: key = 17146
at 20.05 s: key = 31576
at 20.1 s: @stop
-- stdout --
"violated_after":7,"changes":6
"violated_by_step":2007
