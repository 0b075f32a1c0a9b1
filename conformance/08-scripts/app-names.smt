spec 8.77   An element has its own name; a machine has its names after a dot, aliases included.

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
G == 10: @assert a.S == aState and a.aState == 2 and a.pressure == pressure and a.G == G and time == G and a.ready == ready
G == 10: @assert a.S == Go and a.S != Wait and Go == a.S
G == 10: @assert a.seen == 1
G == 10: @stop
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
