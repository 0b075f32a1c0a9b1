# @stop ends the script before asserts noted after it are judged; an assert that was never judged is warned of.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
[Never]
-- app.ss --
[options]
delta_t 1
[all_states]
true {
    @assert x == 0
    @stop
}
true: @assert x == 1    #! W0750 this assert was never evaluated
G == 7: @assert x == 1  #! W0750
[Never]
true: @assert x == 1    #! W0750
-- report --
state script ran for 1 step
1 assert passed
final state vector:
  G = 0
  S = 1
  T = 0
  x = 0.000000
