# NaN in a script: the message says what to write for a sensor that delivers NaN, and that causes no warning.
args test a.sm name.ss
args test a.sm zero.ss
args test a.sm good.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool out
[A] @safe
.step
    out = x > 5
-- name.ss --
[options]
delta_t 10
[all_states]
at 0: x = NaN
at 20: @assert not out
at 30: @stop
-- zero.ss --
[options]
delta_t 10
[all_states]
at 0: x = 0 / 0
at 20: @assert not out
at 30: @stop
-- good.ss --
[options]
delta_t 10
[all_states]
at 0: x = 0
at 20: @assert not out
at 30: @stop
-- stdout --
state script ran for 4 steps
1 assert passed
final state vector:
  G = 30
  S = 1
  T = 30
  out = false
  x = 0.000000
state script ran for 4 steps
1 assert passed
final state vector:
  G = 30
  S = 1
  T = 30
  out = false
  x = 0.000000
-- stderr --
name.ss:4:11: error: unknown element 'NaN' [E0204]
    4 | at 0: x = NaN
      |           ^~~ write 0: a sensor's NaN is read as 0, so this is how a script has a sensor deliver NaN
1 error
zero.ss:4:11: warning: 'x' stores 0: this value is NaN [W0409 constant-range]
    4 | at 0: x = 0 / 0
      |           ^~~~~ write 0: a sensor's NaN is read as 0, so this is how a script has a sensor deliver NaN
1 warning
-- exit --
1 0 0
