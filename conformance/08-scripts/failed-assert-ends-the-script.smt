spec 8.19  The first assert that fails ends the script: later ones are not judged, and the step it fails in is the last.
expect fail

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
G == 1: @assert x == 5   #! E0750
G == 1: @assert x == 6
G == 2: @assert x == 7
G == 3: @stop

-- report --
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 1
  S = 1
  T = 1
  c = 7.000000
  k = 5.000000
  p = 0.000000
  q = 0.000000
  x = 0.000000
