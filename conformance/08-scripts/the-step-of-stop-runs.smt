spec 8.20  The machine makes its step before @stop ends the script.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 99
G == 1: p = 5
G == 1: @stop

-- report --
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 1
  S = 2
  T = 0
  c = 7.000000
  k = 5.000000
  p = 5.000000
  q = 0.000000
  x = 1005.000000
