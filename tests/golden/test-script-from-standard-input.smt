# Beside a machine, standard input is a script; without one it is the machine.
args test a.sm -
args test a.sm /dev/stdin
args test a.sm - good.ss -v --junit=results.xml; grep '<testcase' results.xml | sed 's/time="[^"]*"/time=""/'
args test a.sm - --trace=- --trace-elements=open
args test a.sm - -
args test a.sm - /dev/stdin
args test - -

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- good.ss --
[options]
delta_t 10
[all_states]
open == true: @stop
-- stdin --
[options]
delta_t 10
[all_states]
true: @assert not open
open == true: @stop
-- stdout --
<stdin>:
state script ran for 1 step
0 asserts passed
final state vector:
  G = 0
  S = 1
  T = 0
  open = true
good.ss:
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 10
  S = 1
  T = 10
  open = true
1 passed, 1 failed
    <testcase name="&#60;stdin&#62;" classname="a" time="">
    <testcase name="good.ss" classname="a" time=""/>
script,step,G,state,open
<stdin>,1,0,Idle,1
-- stderr --
<stdin>:4:15: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | true: @assert not open
      |               ^~~~~~~~ open = true
note: the step, and the values after it:
      step  G  state  open
         1  0  Idle   true
note: the machine has been in state 'Idle' from the start
a.sm:7:5: note: step 1 (G = 0): `open = true` was executed
1 error
<stdin>:4:15: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | true: @assert not open
      |               ^~~~~~~~ open = true
note: the step, and the values after it:
      step  G  state  open
         1  0  Idle   true
note: the machine has been in state 'Idle' from the start
a.sm:7:5: note: step 1 (G = 0): `open = true` was executed
1 error
<stdin>:4:15: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | true: @assert not open
      |               ^~~~~~~~ open = true
note: the step, and the values after it:
      step  G  state  open
         1  0  Idle   true
note: the machine has been in state 'Idle' from the start
a.sm:7:5: note: step 1 (G = 0): `open = true` was executed
1 error
good.ss:4:15: warning: the script has no @assert, @expect or @fail: it tests only that @stop is reached [W0751 script-without-assert]
    4 | open == true: @stop
      |               ^~~~~
1 warning
<stdin>:4:15: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | true: @assert not open
      |               ^~~~~~~~ open = true
note: the step, and the values after it:
      step  G  state  open
         1  0  Idle   true
note: the machine has been in state 'Idle' from the start
a.sm:7:5: note: step 1 (G = 0): `open = true` was executed
1 error
smc: standard input is named twice, but can be read only once
Try 'smc test --help'.
smc: standard input is named twice, but can be read only once
Try 'smc test --help'.
smc: standard input is named twice, but can be read only once
Try 'smc test --help'.
-- exit --
1 1 0 1 2 2 2
