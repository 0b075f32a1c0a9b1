spec 8.72   The ticks are the greatest common divisor of all periods apart, also of groups without machines; every group runs in the first.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 5 ms:
    task navigation
every 10 ms:
    machine a "a.sm"
every 25 ms:
    machine b "b.sm"
-- flight.ss --
[all_states]
G == 0: @assert aSteps == 1 and bSteps == 1
G == 5: @assert aSteps == 1 and bSteps == 1
G == 10: @assert aSteps == 2 and bSteps == 1
G == 20: @assert aSteps == 3 and bSteps == 1
G == 25: @assert aSteps == 3 and bSteps == 2
G == 50: @assert aSteps == 6 and bSteps == 3
G == 50: @stop
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
