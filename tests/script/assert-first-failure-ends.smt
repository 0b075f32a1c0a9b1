# Noted items are judged in order, and the first assert that fails ends the script.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    x = 2
-- app.ss --
[options]
delta_t 1
[all_states]
true: @assert x == 2
true: @assert x == 3    #! E0750 x = 2
true: @assert x == 4
true: @stop
-- report --
state script ran for 1 step
1 assert passed
final state vector:
  G = 0
  S = 1
  T = 0
  x = 2.000000
