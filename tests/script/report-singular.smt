# One step, one assert; an element that has an alias stands once, under the name that comes first in ASCII order.

-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 Zeta @alias Beta
F64 a @alias b
F64 B
F64 _x
[Only]
-- app.ss --
[options]
delta_t 1
[all_states]
true {
    @assert true
    @stop
}
-- report --
state script ran for 1 step
1 assert passed
final state vector:
  B = 0.000000
  Beta = 0.000000
  G = 0
  S = 1
  T = 0
  _x = 0.000000
  a = 0.000000
