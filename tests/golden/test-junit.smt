# The same as JUnit XML.
args test --junit=r.xml cases a.sm bad.ss >/dev/null 2>&1; cat r.xml

-- cases/good.smt --
\-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- cases/bad.smt --
\-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    y = 1
    x = z       #! E0204 unknown element 'z'
    x = 2       #! W0501 nothing
-- cases/inner/report.smt --
on ref
\-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Idle]
.step
    x = x + 1
\-- app.ss --
[options]
delta_t 1
[all_states]
G == 1: @stop
\-- report --
state script ran for 2 steps
0 asserts passed
final state vector:
  G = 2
  S = 1
  T = 1
  x = 2.000000
\-- trace --
1 x 0x1p+0
2 x 0x1p+2
-- cases/.hidden.smt --
-- cases/note.txt --
-- cases/malformed.smt --
expect perhaps
-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 20: @assert not open
G == 30: @stop
-- stdout --
<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="smc test" tests="5" failures="3" errors="1" time="[..]">
  <testsuite name="a.sm" tests="1" failures="1" errors="0" skipped="0" time="[..]" file="a.sm">
    <testcase name="bad.ss" classname="a" time="[..]">
      <failure message="bad.ss:4:18: error: assert failed after step 3 (G = 20, state Idle) [E0750]" type="E0750">bad.ss:4:18: error: assert failed after step 3 (G = 20, state Idle) [E0750]
    4 | G == 20: @assert not open
      |                  ^~~~~~~~ open = true
note: the last steps, and the values after each:
      step   G  state  open
         1   0  Idle   true
         2  10  Idle   true
         3  20  Idle   true
note: the machine has been in state 'Idle' from the start
a.sm:7:5: note: step 3 (G = 20): `open = true` was executed
1 error
</failure>
    </testcase>
  </testsuite>
  <testsuite name="cases" tests="3" failures="1" errors="1" skipped="0" time="[..]">
    <testcase name="bad.smt" classname="cases" time="[..]">
      <failure message="not announced: app.sm:7:5: error: unknown element 'y' [E0204]" type="E0204">not announced: app.sm:7:5: error: unknown element 'y' [E0204]
announced, but not reported: app.sm:9: W0501 nothing
</failure>
    </testcase>
    <testcase name="good.smt" classname="cases" time="[..]"/>
    <testcase name="malformed.smt" classname="cases" time="[..]">
      <error message="line 1: expect takes pass, fail or error">line 1: expect takes pass, fail or error</error>
    </testcase>
  </testsuite>
  <testsuite name="cases/inner" tests="1" failures="1" errors="0" skipped="0" time="[..]">
    <testcase name="report.smt" classname="cases.inner" time="[..]">
      <failure message="the report differs (- expected, + came):">the report differs (- expected, + came):
  -   G = 2
  +   G = 1
the trace has no line '2 x 0x1p+2' here; it has '2 x 0x1p+1'
</failure>
    </testcase>
  </testsuite>
</testsuites>
