# An assert that tests less than it seems to.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
U8   code
[define]
A = 1
B = 2
[One] @safe
.step
    code = 3
-- a.ss --
[options]
delta_t 10
[all_states]
G >= 10: @assert code == A or code != B
G == 30: @stop
-- stdout --
state script ran for 4 steps
3 asserts passed
final state vector:
  G = 30
  S = 1
  T = 30
  code = 3
-- stderr --
a.sm:6:1: warning: definition 'A' is never used [W0212 unused-definition]
    6 | A = 1
      | ^
a.sm:7:1: warning: definition 'B' is never used [W0212 unused-definition]
    7 | B = 2
      | ^
2 warnings
a.ss:4:18: warning: 'code == A' changes nothing here [W0522 absorbed-operand]
    4 | G >= 10: @assert code == A or code != B
      |                  ^~~~~~~~~ wherever it is true, 'code != B' is true; correct one of the two operators, or leave it out
1 warning
