spec 8.78   The machine and its name exist.
expect error
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
c.T == 0: ready = true         #! E0792 c
aa.T == 0: ready = true        #! E0792 aa
a.sen > 0: ready = true        #! E0793 did you mean 'a.seen'?
a.S == Got: ready = true      #! E0501 did you mean 'Go'?
a.S == b.Shut: ready = true   #! E0501 unknown state 'b.Shut'
b.S != b.Open: ready = true   #! E0501 write Open
a.S == a.Go: ready = true     #! E0501 write Go
G == 10: @stop
[a.Wai]                        #! E0793 did you mean 'a.Wait'?
G == 1: ready = true
[d.Wait]                       #! E0792 d
G == 1: ready = true
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
