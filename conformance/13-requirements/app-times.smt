spec 13.24  Times are converted to the unit of the application's time.
expect fail

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 10 ms:
    machine a "a.sm"
every 20 ms:
    machine b "b.sm"
-- flight.rq --
R1 "in time"   always p == 1 leads to a.S == Go within 0.01 s
R2 "too late"  always p == 1 leads to a.S == Go within 9 ms     #! E1310 in step 2
-- flight.ss --
[all_states]
G == 10: p = 1
G == 30: @stop
-- rocket.sv --
[A]
U64  time
U32  aState
U32  bState
U8   mode
F64  p
bool ready
bool valve
-- a.sm --
[state_vector]
U64  time   @alias G
U32  aState @alias S
F64  p      @read_only
bool ready

[Wait] @safe
.step
    ready = false
    p == 1: -> Go

[Go] @safe
.step
    ready = true
    p == 0: -> Wait
-- b.sm --
[state_vector]
U64  time   @alias G
U32  bState @alias S
bool ready  @read_only
bool valve

[Shut] @safe @req R1
.step
    valve = false
    ready: -> Open

[Open] @safe
.step
    valve = true
    not ready: -> Shut
