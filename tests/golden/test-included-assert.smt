# What a run reports in a file that several scripts include names the script, by the line that includes the file, also through another file.
args test a.sm t1.ss t2.ss
args test a.sm t3.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool out
[A] @safe
.step
    out = x > 5
-- ok.ss --
[all_states]
at 20: @assert out
at 70: @assert out
x > 9 and G > 0: @assert out
at 30: @stop
-- more.ss --
include "ok.ss"
[local]
F64 y = 8
-- t1.ss --
include "ok.ss"
[options]
delta_t 10
[all_states]
true: x = 1
-- t2.ss --
include "more.ss"
[options]
delta_t 10
[all_states]
true: x = y - 6
-- t3.ss --
include "more.ss"
[options]
delta_t 10
[all_states]
true: x = y
-- stdout --
failed: t1.ss: ok.ss:2:16: error: assert failed after step 3 (G = 20, state A) [E0750]
failed: t2.ss: ok.ss:2:16: error: assert failed after step 3 (G = 20, state A) [E0750]
0 passed, 2 failed
state script ran for 4 steps
1 assert passed
final state vector:
  G = 30
  S = 1
  T = 30
  out = true
  x = 8.000000
-- stderr --
ok.ss:2:16: error: assert failed after step 3 (G = 20, state A) [E0750]
    2 | at 20: @assert out
      |                ^~~ out = false
t1.ss:1:9: note: the script that ran includes it here
note: the last steps, and the values after each:
      step   G  state    out
         1   0  A      false
         2  10  A      false
         3  20  A      false
note: the machine has been in state 'A' from the start
a.sm:8:5: note: step 3 (G = 20): `out = x > 5` stored false: x = 1
1 error
ok.ss:2:16: error: assert failed after step 3 (G = 20, state A) [E0750]
    2 | at 20: @assert out
      |                ^~~ out = false
t2.ss:1:9: note: the script that ran includes it here
note: the last steps, and the values after each:
      step   G  state    out
         1   0  A      false
         2  10  A      false
         3  20  A      false
note: the machine has been in state 'A' from the start
a.sm:8:5: note: step 3 (G = 20): `out = x > 5` stored false: x = 2
1 error
ok.ss:3:16: warning: this assert was never evaluated [W0750 unjudged-assert]
    3 | at 70: @assert out
      |                ^~~ its condition was never true
t3.ss:1:9: note: the script that ran includes it here
ok.ss:4:26: warning: this assert was never evaluated [W0750 unjudged-assert]
    4 | x > 9 and G > 0: @assert out
      |                          ^~~ its condition was never true
t3.ss:1:9: note: the script that ran includes it here
2 warnings
-- exit --
1 0
