# JUnit has a suite for each file of requirements.
args test --junit=o.xml a.sm a.ss a.rq >/dev/null 2>&1; sed "s/time=\"[0-9.]*\"/time=\"0\"/g" o.xml

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad] @req R1
.step
    p > 100: -> Drogue @req R3
[Drogue]
.entry
    drogue = true @req R4
.step
    if T > 50 { -> Main } @req R3
[Main] @safe
.entry
    main = true
-- a.ss --
[all_states]
G == 0: p = 0
G == 100: p = 200
G == 300 {
    @assert main @req R2
    @stop
}
-- a.rq --
R1 "low pressure"   never S == Drogue and roll_max(p, 3 steps) > 10
R2 "main first"     never Drogue before Main
R3 "main in time"   always p > 100 leads to main within 40 ms
R4 "through main"   never Drogue after Pad without Main
R5 "main goes off"  always main leads to not main within 10 s
-- stdout --
<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="smc test" tests="6" failures="4" errors="0" time="0">
  <testsuite name="a.sm" tests="1" failures="1" errors="0" skipped="0" time="0" file="a.sm">
    <testcase name="a.ss" classname="a" time="0">
      <properties>
        <property name="requirement" value="R1"/>
        <property name="requirement" value="R2"/>
        <property name="requirement" value="R4"/>
      </properties>
      <failure message="a.rq:1:27: error: requirement R1 violated in step 12 (G = 110, state Drogue): low pressure [E1310]" type="E1310">a.rq:1:27: error: requirement R1 violated in step 12 (G = 110, state Drogue): low pressure [E1310]
    1 | R1 &#34;low pressure&#34;   never S == Drogue and roll_max(p, 3 steps) &#62; 10
      |                           ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ S = Drogue, number 2, roll_max(p, 3 steps) = 200
a.ss:1:1: note: this script ran
note: the last steps, and the values after each:
      step    G  state                  S  roll_max(p, 3 steps)
         8   70  Pad        Pad, number 1                     0
         9   80  Pad        Pad, number 1                     0
        10   90  Pad        Pad, number 1                     0
        11  100  Pad        Pad, number 1                   200
        12  110  Drogue  Drogue, number 2                   200
a.sm:11:14: note: transition in step 11 (G = 100): Pad -&#62; Drogue
a.rq:2:27: error: requirement R2 violated in step 12 (G = 110, state Drogue): main first [E1310]
    2 | R2 &#34;main first&#34;     never Drogue before Main
      |                           ^~~~~~
a.ss:1:1: note: this script ran
a.rq:2:41: note: no earlier step had 'Main'
a.rq:4:27: error: requirement R4 violated in step 12 (G = 110, state Drogue): through main [E1310]
    4 | R4 &#34;through main&#34;   never Drogue after Pad without Main
      |                           ^~~~~~
a.ss:1:1: note: this script ran
a.rq:4:52: note: the last step with 'Pad' was at G = 100, and none has had 'Main' since
3 errors
</failure>
    </testcase>
  </testsuite>
  <testsuite name="a.rq" tests="5" failures="3" errors="0" skipped="2" time="0" file="a.rq">
    <testcase name="R1 low pressure" classname="a" time="0">
      <properties>
        <property name="requirement" value="R1"/>
        <property name="judged" value="a.ss: 12"/>
        <property name="implemented" value="a.sm:9"/>
      </properties>
      <failure message="violated"/>
    </testcase>
    <testcase name="R2 main first" classname="a" time="0">
      <properties>
        <property name="requirement" value="R2"/>
        <property name="judged" value="a.ss: 1"/>
        <property name="not visited" value="Main"/>
      </properties>
      <failure message="violated"/>
    </testcase>
    <testcase name="R3 main in time" classname="a" time="0">
      <properties>
        <property name="requirement" value="R3"/>
        <property name="implemented" value="a.sm:11, a.sm:16"/>
      </properties>
      <skipped message="undecided"/>
    </testcase>
    <testcase name="R4 through main" classname="a" time="0">
      <properties>
        <property name="requirement" value="R4"/>
        <property name="judged" value="a.ss: 1"/>
        <property name="not visited" value="Main"/>
        <property name="implemented" value="a.sm:14"/>
      </properties>
      <failure message="violated"/>
    </testcase>
    <testcase name="R5 main goes off" classname="a" time="0">
      <properties>
        <property name="requirement" value="R5"/>
      </properties>
      <skipped message="never judged"/>
    </testcase>
  </testsuite>
</testsuites>
