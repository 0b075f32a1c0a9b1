# A failed assert names the step, G and the state, and the values it was made of.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F32 q
bool open
[Idle]
.step
    p = p + 0.1
    open = p > 0.25
-- app.ss --
[options]
delta_t 5
[Idle]
G <= 10: @assert p < 1
open: @assert open == (p + q * 2 <= 0.25)     #! E0750 after step 4 (G = 15, state Idle)
G == 100: @stop
-- report --
state script ran for 4 steps
3 asserts passed
final state vector:
  G = 15
  S = 1
  T = 15
  open = true
  p = 0.400000
  q = 0.000000
