spec 8.84   With 'delta_t file' each row is a tick, and a group runs when a period of it has ended since the last tick.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine a "a.sm"
every 20 ms:
    machine b "b.sm"
-- d.csv --
t,P
100,1
107,2
110,3
112,4
125,5
126,6
140,7
200,8
-- flight.ss --
[options]
delta_t file
[data]
file "d.csv"
time "t" ms
p = "P"
[local]
U32 ticks = 0
[all_states]
true: ticks = ticks + 1
at 0:   @assert p == 1 and ticks == 1 and aSteps == 1 and bSteps == 1
at 7:   @assert p == 2 and ticks == 2 and aSteps == 1 and a.T == 0
at 10:  @assert p == 3 and aSteps == 2 and bSteps == 1 and a.T == 10
at 12:  @assert aSteps == 2 and bSteps == 1
at 25:  @assert p == 5 and aSteps == 3 and bSteps == 2 and a.T == 25
at 26:  @assert aSteps == 3 and bSteps == 2
at 40:  @assert aSteps == 4 and bSteps == 3 and a.S == High and a.T == 0
at 100: @assert aSteps == 5 and bSteps == 4 and ticks == 8
at 100: @stop
[a.Low]
true: @assert G == 0 or G == 10 or G == 25
-- rocket.sv --
[A]
U64  time
U32  aState
U32  bState
F64  p
U32  aSteps
U32  bSteps
-- a.sm --
[state_vector]
U64  time   @alias G
U32  aState @alias S
F64  p      @read_only
U32  aSteps

[Low] @safe
.step
    aSteps = aSteps + 1
    p > 3: -> High

[High] @safe
.step
    aSteps = aSteps + 1
-- b.sm --
[state_vector]
U64  time   @alias G
U32  bState @alias S
U32  bSteps

[Run] @safe
.step
    bSteps = bSteps + 1
