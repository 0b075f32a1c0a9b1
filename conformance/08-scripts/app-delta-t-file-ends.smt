spec 8.84, 8.68   After the last row there is no tick.
expect fail

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
delta_t file         #! E0780
[data]
file "d.csv"
time "t" ms
p = "P"
[all_states]
true: @assert aSteps > 0
G > 100: @stop
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
