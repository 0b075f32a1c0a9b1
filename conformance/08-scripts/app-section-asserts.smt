spec 8.76   Asserts of a section are judged at the ticks of its machine.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 10 ms:
    machine a "a.sm"
every 20 ms:
    machine b "b.sm"
-- flight.ss --
[a.Wait]
G == 40: pressure = 20
[a.Go]
a.T == 0: @assert G == 50 and ready
[b.Shut]
true: @assert G == 20 * floor(G / 20)
true: @assert b.T == G
[b.Open]
b.T == 0: @assert G == 80 and valve
b.T == 0: @stop
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
