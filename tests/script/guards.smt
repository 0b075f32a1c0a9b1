# A guard is evaluated once: what its inputs change does not reach its asserts; later guards see the inputs.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 seen
[Idle]
.step
    seen = x
    x = 10
-- app.ss --
[options]
delta_t 1
[all_states]
x == 0 {
    x = 1
    x = x + 1
    @assert seen == 2 and x == 10
}
x == 0: @assert false
x == 2: @assert seen == 2
x == 10: @assert seen == 10
G == 3: @stop
-- report --
state script ran for 4 steps
5 asserts passed
final state vector:
  G = 3
  S = 1
  T = 3
  seen = 10.000000
  x = 10.000000
