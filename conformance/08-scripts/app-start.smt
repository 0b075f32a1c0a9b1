spec 8.74   Values of [start] are set, machines start in the state of @state, and time counts from the value of G.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[start]
pressure = 2.5
aSteps = 7
time = 100
[flight]
every 10 ms:
    machine a "a.sm" @state Go
    machine b "b.sm"
-- flight.ss --
[all_states]
G == 100: @assert pressure == 2.5 and a.S == Go and aSteps == 8 and ready
G == 110: @assert aSteps == 9
G == 110: @stop
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
