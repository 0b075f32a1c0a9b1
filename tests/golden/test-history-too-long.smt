# Where a second run would take too long, the last steps are not shown; where the machine is, is known all the same.
args test a.sm a.ss --max-steps=20000

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 highest
[Idle]
.step
    p > 1: -> Coast
[Coast]
.step
    highest = roll_max(p, 60000)
-- a.ss --
[options]
delta_t 10
[all_states]
G == 1000: p = 2
true: @assert highest <= 2
[Idle]
T == 2000: @stop
-- stderr --
a.ss:7:12: error: the script did not reach @stop within 20000 steps [E0751]
    7 | T == 2000: @stop
      |            ^~~~~
a.ss:7:12: note: section [Idle] last ran in step 101 (G = 1000), and this condition was never true in it
note: the machine has been in state 'Coast' since step 102 (G = 1010)
note: the run is too long, with its windows, to show its last steps: --trace=FILE writes them
1 error
-- exit --
1
