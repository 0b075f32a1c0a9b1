# A failure is called by its error, not by a warning that stands above it; on standard output the XML stands alone.
args test --junit=- a.sm bad.ss good.ss 2>/dev/null
args test --junit=- a.sm good.ss
args test --junit=- --tap a.sm good.ss
args test --junit=- --trace=- a.sm good.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x
bool open
[Idle]
.step
    open = true
-- bad.ss --
[options]
delta_t 10
[all_states]
true: @assert not open == (x < 1)
G == 30: @stop
-- good.ss --
[options]
delta_t 10
[all_states]
G == 30: @stop
-- stdout --
<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="smc test" tests="2" failures="1" errors="0" time="[..]">
  <testsuite name="a.sm" tests="2" failures="1" errors="0" skipped="0" time="[..]" file="a.sm">
    <testcase name="bad.ss" classname="a" time="[..]">
      <failure message="bad.ss:4:15: error: assert failed after step 1 (G = 0, state Idle) [E0750]" type="E0750">bad.ss:4:15: warning: 'not' applies only to the next value [W0401 not-precedence]
    4 | true: @assert not open == (x &#60; 1)
      |               ^~~~~~~~
note: as written: (not open) == (x &#60; 1)
note: perhaps meant: not (open == (x &#60; 1))
bad.ss:4:15: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | true: @assert not open == (x &#60; 1)
      |               ^~~~~~~~~~~~~~~~~~~ open = true, not open = 0, x = 0, x &#60; 1 = 1
note: the step, and the values after it:
      step  G  state  open  x
         1  0  Idle   true  0
note: the machine has been in state 'Idle' from the start
a.sm:8:5: note: step 1 (G = 0): `open = true` was executed
1 error, 1 warning
</failure>
    </testcase>
    <testcase name="good.ss" classname="a" time="[..]"/>
  </testsuite>
</testsuites>
<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="smc test" tests="1" failures="0" errors="0" time="[..]">
  <testsuite name="a.sm" tests="1" failures="0" errors="0" skipped="0" time="[..]" file="a.sm">
    <testcase name="good.ss" classname="a" time="[..]"/>
  </testsuite>
</testsuites>
-- stderr --
a.sm:4:5: warning: element 'x' is never used [W0203 unused-element]
    4 | F64 x
      |     ^
1 warning
good.ss:4:10: warning: the script has no @assert, @expect or @fail: it tests only that @stop is reached [W0751 script-without-assert]
    4 | G == 30: @stop
      |          ^~~~~
1 warning
smc: --tap and --junit cannot both write to standard output
Try 'smc test --help'.
smc: --trace and --junit cannot both write to standard output
Try 'smc test --help'.
-- exit --
1 0 2 2
