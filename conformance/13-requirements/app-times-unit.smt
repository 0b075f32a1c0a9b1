spec 13.24  Without a unit of us, ms or s, times are errors.
expect error

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 100 us

[flight]
every 10 ms:
    machine a "a.sm"
every 20 ms:
    machine b "b.sm"
-- flight.rq --
R1 "in time"  always G == 10 leads to a.S == Go within 0.015 s      #! E0798
-- flight.ss --
[all_states]
G == 200: @assert ready
G == 200: @stop
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
