# G cannot advance beyond 2^64-1: 2^63 is added once.

-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- app.ss --
[options]
delta_t 9223372036854775808     #! E0752 after step 2
[all_states]
G == 1: @stop              #! W0702
-- report --
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 9223372036854775808
  S = 1
  T = 9223372036854775808
