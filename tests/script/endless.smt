# A script that does not reach @stop is given up.
steps 5

-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- app.ss --
[options]
delta_t 10
[all_states]
G == 15: @stop          #! E0751 within 5 steps #! W0702
-- report --
state script ran for 5 steps
0 asserts passed
final state vector:
  G = 40
  S = 1
  T = 40
