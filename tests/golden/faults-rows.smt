# An application whose ticks are the rows of recorded data: runs with faults have these ticks, too.
args faults a.app a.ss --kinds=dead

-- a.sv --
[A]
U64 time
U32 state
F64 p
F64 echo
U32 steps
-- a.app --
[options]
state_vector "a.sv"
time time 1 ms
[flight]
every 10 ms:
    machine main "echo.sm"
every 5 ms:
    task sensor
-- echo.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
F64  p     @read_only @range 0 10
F64  echo
U32  steps
[Run] @safe
.step
    echo = p
    steps = steps + 1
-- d.csv --
t,P
0,1
30,2
60,3
90,4
-- a.ss --
[options]
delta_t file
[data]
file "d.csv"
time "t" ms
p = "P"
[all_states]
G == 90: @assert steps == 4
G == 90: @stop
-- stdout --
faults of a: 1 input, 2 triggers in 1 script; 2 of 2 faults have an effect
input  dead
p      echo
an output or a state differs on the way:
  p dead from the start, in main.Run (G = 0, a.ss): echo = 0 instead of 1 at G = 0; and 1 more trigger
smc faults -v lists each trigger
note: 'p' has no @range; its range in the runs without a fault is 1 to 4
