spec 13.23  The first state of a machine that is disabled has not run, although it is its S.
expect fail

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 10 ms:
    machine a "a.sm" @mode mode
every 20 ms:
    machine b "b.sm"
-- flight.rq --
R1 "a first"  never (p == 2) before a.Wait          #! E1310 in step 3
R2 "its S"    never (p == 2) before (a.S == Wait)
-- flight.ss --
[all_states]
G == 20: p = 2
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
