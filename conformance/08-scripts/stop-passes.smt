spec 8.20  @stop ends the script as passed, in the step in which its guard was true.

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
true: @assert G <= 2
G == 2: @stop

-- report --
state script ran for 3 steps
3 asserts passed
final state vector:
  G = 2
  S = 1
  T = 2
  c = 7.000000
  k = 5.000000
  p = 0.000000
  q = 0.000000
  x = 0.000000
