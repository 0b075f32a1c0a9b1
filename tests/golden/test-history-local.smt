# A failed assert shows the variables of the script as it shows those of the machine.
args test a.sm bad.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 pressure
[Idle]
.step
    pressure = pressure + 0.5
-- bad.ss --
[options]
delta_t 10
[local]
F64 sum = 0
U8 limit = 2 @read_only
[all_states]
true: sum = sum + pressure
true: @assert sum < limit
G == 90: @stop
-- stderr --
bad.ss:8:15: error: assert failed after step 4 (G = 30, state Idle) [E0750]
    8 | true: @assert sum < limit
      |               ^~~~~~~~~~~ sum = 3, limit = 2
note: the last steps, and the values after each:
      step   G  state  sum
         1   0  Idle     0
         2  10  Idle   0.5
         3  20  Idle   1.5
         4  30  Idle     3
note: the machine has been in state 'Idle' from the start
1 error
-- exit --
1
