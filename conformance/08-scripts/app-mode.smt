spec 8.75, 8.76   A machine steps only while its mode is 2; otherwise it keeps its state, its T and its samples.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 10 ms:
    machine a "a.sm" @mode mode
    machine b "b.sm"
-- flight.ss --
[all_states]
G == 0: mode = 2
G == 20: mode = 1
G == 40: mode = 2
G == 60: mode = 3
G == 80: mode = 0
G == 10: @assert aSteps == 2 and a.T == 10
G == 30: @assert aSteps == 2 and a.T == 10
G == 40: @assert aSteps == 3 and a.T == 40
G == 90: @assert aSteps == 4 and a.seen == 4 and bSteps == 10
G == 90: @stop
[a.Wait]
true: @assert G == 10 or G == 20 or G == 50 or G == 60
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
