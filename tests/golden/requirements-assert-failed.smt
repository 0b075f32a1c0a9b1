# A failed assert of a requirement is marked as such in the table, in JUnit, in TAP and in the report, although no step has judged the requirement.
args test a.sm a.ss b.ss a.rq -w 2>/dev/null
args test a.sm a.ss a.rq -w --junit=- 2>/dev/null | grep 'tested by'
args test a.sm a.ss a.rq -w --tap 2>/dev/null | grep 'tested by'
args report a.sm a.ss a.rq --format=text 2>/dev/null | grep 'a.ss:4 (failed)' | tr -s ' '

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
bool on
[Run] @safe
.step
    on = p > 2
-- a.ss --
[options]
delta_t 10
[all_states]
at 10: @assert on "it is on" @req R1
at 20: @stop
-- b.ss --
[options]
delta_t 10
[all_states]
at 0: p = 3
at 10: @assert on @req R1
at 20: @stop
-- a.rq --
R1 "on"  always p > 5 implies on
-- stdout --
1 passed, 1 failed
requirements:
  R1  never judged  on
      tested by a.ss:4 (failed), b.ss:5
        <property name="tested by" value="a.ss:4 (failed)"/>
# tested by a.ss:4 (failed)
 R1 on a.rq:1 nowhere a.ss:4 (failed) no script 0 never judged
-- exit --
1 0 0 0
