# A failed assert is a diagnostic with the values it was made of; then the report.
args test a.sm bad.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 20: @assert not open
G == 30: @stop
-- stdout --
state script ran for 3 steps
0 asserts passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
-- stderr --
bad.ss:4:18: error: assert does not hold after step 3 (G = 20, state Idle) [E0750]
    4 | G == 20: @assert not open
      |                  ^~~~~~~~ open = true
1 error
-- exit --
1
