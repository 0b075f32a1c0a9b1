spec 13.23  Parts of a machine have the name of the machine before them.
expect error

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
R1 "T"      never T == 3              #! E0790 a.T
R2 "state"  never Go before b.Open    #! E0790 a.Go
R3 "no x"   never b.Go before a.Go    #! E0793
R4 "no c"   never c.T > 1             #! E0792
R5 "T"      never a.T before a.Go     #! E1309
-- flight.ss --
[all_states]
G == 20: @assert ready
G == 20: @stop
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
