# A script that does not reach @stop is given up.
args test --max-steps=2 a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- stdout --
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 10
  S = 1
  T = 10
  open = true
-- stderr --
a.ss:5:13: warning: this assert was never judged [W0750 unjudged-assert]
    5 |     @assert open
      |             ^~~~
a.ss:6:5: error: the script did not reach @stop within 2 steps [E0751]
    6 |     @stop
      |     ^~~~~
1 error, 1 warning
-- exit --
1
