spec 8.20, 8.16  Whether an assert of another section is judged is a matter of the order in the file.

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

[A]
G == 1: @assert x == 0

[all_states]
G == 1: @stop

[B]
false: @assert false

-- report --
state script ran for 2 steps
1 assert passed
final state vector:
  G = 1
  S = 1
  T = 1
  c = 7.000000
  k = 5.000000
  p = 0.000000
  q = 0.000000
  x = 0.000000
