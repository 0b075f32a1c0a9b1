# An assert that was never judged is warned of; the warning can be switched off, or fail the test.
args test a.sm a.ss
args test -Wno-unjudged-assert a.sm a.ss
args test -Werror=unjudged-assert a.sm a.ss

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
G == 15: @assert open
G == 20: @stop
-- stdout --
state script ran for 3 steps
0 asserts passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
state script ran for 3 steps
0 asserts passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
-- stderr --
a.ss:4:18: warning: this assert was never evaluated [W0750 unjudged-assert]
    4 | G == 15: @assert open
      |                  ^~~~ its condition was never true
1 warning
a.ss:4:18: error: this assert was never evaluated [W0750 unjudged-assert]
    4 | G == 15: @assert open
      |                  ^~~~ its condition was never true
1 error
-- exit --
0 0 1
