spec 8.71, 8.73   Two machines run in each tick, in the order of the .app, over one state vector.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 10 ms:
    machine a "a.sm"
    machine b "b.sm"
-- flight.ss --
[all_states]
G == 0: pressure = 11
G == 0: @assert a.S == Wait and b.S == Shut and not ready
G == 10: @assert a.S == Go and b.S == Shut and ready
G == 20: @assert b.S == Open and valve
G == 20: @stop
-- rocket.sv --
[A]
U64  time
U32  aState
U32  bState
F64  pressure
bool ready
bool valve
U8   mode
U32  aSteps
U32  bSteps
-- a.sm --
[state_vector]
U64  time   @alias G
U32  aState @alias S
F64  pressure @read_only
bool ready
U32  aSteps

[local]
U32 seen = 0

[Wait] @safe
.step
    aSteps = aSteps + 1
    seen = seen + 1
    pressure > 10: -> Go

[Go] @safe
.step
    aSteps = aSteps + 1
    ready = true
    seen > 1000: -> Wait
-- b.sm --
[state_vector]
U64  time   @alias G
U32  bState @alias S
bool ready  @read_only
bool valve
U32  bSteps

[Shut] @safe
.step
    bSteps = bSteps + 1
    ready: -> Open

[Open] @safe
.step
    bSteps = bSteps + 1
    valve = true
