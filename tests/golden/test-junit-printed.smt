# The results of a script that prints, has random numbers and tests a requirement replace those of an earlier call.
args test a.sm a.ss --junit=o.xml >/dev/null
args test a.sm a.ss --junit=o.xml >/dev/null
args test a.sm b.ss --junit=o.xml >/dev/null 2>&1
args test a.sm a.ss --junit=o.xml >/dev/null; sed "s/time=\"[0-9.]*\"/time=\"0\"/g" o.xml

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool on
[A] @safe
.step
    on = x > 5
-- a.ss --
[options]
delta_t 10
[all_states]
at 0: x = 7 + noise(0)
at 0: @print x "at <first>"
at 0: @assert on @req R1
at 10: @stop
-- b.ss --
include "c.ss"
[options]
delta_t 10
[all_states]
at 0: @print x
at 10: @stop
-- c.ss --
[all_states]
at 0: @assert on "is on" @req R1
-- stdout --
<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="smc test" tests="1" failures="0" errors="0" time="0">
  <testsuite name="a.sm" tests="1" failures="0" errors="0" skipped="0" time="0" file="a.sm">
    <testcase name="a.ss" classname="a" time="0">
      <properties>
        <property name="seed" value="0"/>
        <property name="requirement" value="R1"/>
      </properties>
      <system-out>step 1 (G = 0), at &#60;first&#62;: x = 7
</system-out>
    </testcase>
  </testsuite>
</testsuites>
-- exit --
0 0 1 0
