spec 8.76   A section of a state runs at the ticks of its machine, [all_states] at every tick.

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
[local]
U32 ofA = 0
U32 ofB = 0
U32 all = 0
[a.Wait]
true: ofA = ofA + 1
[b.Shut]
true: ofB = ofB + 1
[all_states]
true: all = all + 1
G == 40: @assert ofA == 5 and ofB == 3 and all == 5
G == 40: @stop
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
