spec 8.72   The period of a task in C counts for the ticks, although no machine steps in its group.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[navigation]
every 4 ms:
    task navigation

[flight]
every 10 ms:
    machine a "a.sm"
every 30 ms:
    machine b "b.sm"
-- flight.ss --
[all_states]
at 2 ms: @assert aSteps == 1 and bSteps == 1
at 8 ms: @assert aSteps == 1
at 10 ms: @assert aSteps == 2 and bSteps == 1
at 28 ms: @assert aSteps == 3 and bSteps == 1
at 30 ms: @assert aSteps == 4 and bSteps == 2
at 30 ms: @stop
-- rocket.sv --
[options]
lock
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
