spec 13.23  A state of a machine counts only in the ticks in which the machine steps.

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
# b steps at 0, 20, 40 and 60, and is Open from 40 on. The C at 50 is between its steps at 40 and 60.
R1 "p between"  never (p == 3) after b.Open without (p == 2)
-- flight.ss --
[all_states]
G == 0: p = 1
G == 40: @assert b.S == Open
G == 50: p = 2
G == 60: p = 3
G == 60: @stop
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
