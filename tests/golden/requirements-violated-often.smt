# The steps before a violation are printed for the first script that violates a requirement; JUnit has them for each. Limits of coverage are
# no tests: the last line names them in words.
args test a.sm a.ss b.ss c.ss a.rq -w --min-coverage=guards:50
args test a.sm c.ss e.ss -w --min-coverage=guards:100
args test a.sm a.ss b.ss a.rq -w --junit=j.xml >log; grep -c "the last steps" j.xml

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool valve
[Idle]
.step
    valve = false
    p > 50: -> Vent
[Vent] @safe
.step
    valve = true
-- a.ss --
[all_states]
at 0: p = 20
at 30 ms: p = 60
at 100 ms: @stop
-- b.ss --
[all_states]
at 0: p = 20
at 50 ms: p = 70
at 100 ms: @stop
-- c.ss --
[all_states]
at 0: p = 20
at 100 ms: @stop
-- e.ss --
[all_states]
at 0: p = 20
at 100 ms: @stop
-- a.rq --
R1 "a high pressure opens the valve"  always p > 50 implies valve
-- stdout --
failed: a.ss: a.rq:1:61: error: requirement R1 violated in step 4 (G = 30, state Idle): a high pressure opens the valve [E1310]
failed: b.ss: a.rq:1:61: error: requirement R1 violated in step 6 (G = 50, state Idle): a high pressure opens the valve [E1310]
1 passed, 2 failed; coverage reaches --min-coverage
requirements:
  R1  violated  a high pressure opens the valve
      judged in a.ss: 8, b.ss: 6
2 passed, 0 failed; coverage is below --min-coverage
2
-- stderr --
a.rq:1:61: error: requirement R1 violated in step 4 (G = 30, state Idle): a high pressure opens the valve [E1310]
    1 | R1 "a high pressure opens the valve"  always p > 50 implies valve
      |                                                             ^~~~~ valve = false
a.ss:1:1: note: this script ran
note: the last steps, and the values after each:
      step   G  state  valve
         1   0  Idle   false
         2  10  Idle   false
         3  20  Idle   false
         4  30  Idle   false
a.sm:11:13: note: transition in step 4 (G = 30): Idle -> Vent
a.sm:10:5: note: step 4 (G = 30): `valve = false` was executed
1 error
a.rq:1:61: error: requirement R1 violated in step 6 (G = 50, state Idle): a high pressure opens the valve [E1310]
    1 | R1 "a high pressure opens the valve"  always p > 50 implies valve
      |                                                             ^~~~~ valve = false
b.ss:1:1: note: this script ran; its steps are printed if it runs alone
1 error
a.sm:11:5: error: too few guards are covered: 1 of 2, and 100 % are required [E1400]
   11 |     p > 50: -> Vent
      |     ^~~~~~
a.sm:11:5: note: `p > 50` was never true
1 error
a.rq:1:61: error: requirement R1 violated in step 4 (G = 30, state Idle): a high pressure opens the valve [E1310]
    1 | R1 "a high pressure opens the valve"  always p > 50 implies valve
      |                                                             ^~~~~ valve = false
a.ss:1:1: note: this script ran
note: the last steps, and the values after each:
      step   G  state  valve
         1   0  Idle   false
         2  10  Idle   false
         3  20  Idle   false
         4  30  Idle   false
a.sm:11:13: note: transition in step 4 (G = 30): Idle -> Vent
a.sm:10:5: note: step 4 (G = 30): `valve = false` was executed
1 error
a.rq:1:61: error: requirement R1 violated in step 6 (G = 50, state Idle): a high pressure opens the valve [E1310]
    1 | R1 "a high pressure opens the valve"  always p > 50 implies valve
      |                                                             ^~~~~ valve = false
b.ss:1:1: note: this script ran; its steps are printed if it runs alone
1 error
-- exit --
1 1 0
