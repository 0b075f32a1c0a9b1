# A script that fails shows what its assert reads in the last steps, and which lines made the last transitions; @assert false what its
# condition reads.  The whole state vector is shown with -v.
args test a.sm a.ss
args test a.sm a.ss --engine=all -v
args test a.sm b.ss
args test a.sm c.ss
args test a.sm a.ss b.ss good.ss -v
args test a.sm a.ss --message-format=json

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 highest
bool open
[local]
U8 limit = 50 @read_only
U8 n = 0
[Idle]
.step
    n = n + 1
    highest = max(highest, p)
    open = roll_avg(p, 2) > 5
    p > limit: -> Abort
    p > 30 and n > 3: -> Abort
[Abort]
.entry
    p > 90: -> Idle
.step
    open = false
    if n > 4: -> Idle
    else if p > 70: -> Idle
-- a.ss --
[options]
delta_t 10
[all_states]
true: p = G / 2
G == 110: p = 60
G == 160: @stop
n > 6: @assert (p < limit or highest < 55) and not open and roll_max(p, 3) < G
-- b.ss --
[options]
delta_t 10
[all_states]
p > -1: @assert false
G == 160: @stop
-- c.ss --
[options]
delta_t 10
[all_states]
G == 20: p = 60
G == 30: p = 0
true: @assert p >= 0
[Abort]
G == 45: @stop
-- good.ss --
[options]
delta_t 10
[all_states]
true: @assert p == 0
G == 10: @stop
-- stdout --
state script ran for 8 steps
0 asserts passed
final state vector:
  G = 70
  S = 1
  T = 70
  highest = 35.000000
  limit = 50
  n = 8
  open = true
  p = 35.000000
a.ss:
state script ran for 8 steps
0 asserts passed
final state vector:
  G = 70
  S = 1
  T = 70
  highest = 35.000000
  limit = 50
  n = 8
  open = true
  p = 35.000000
b.ss:
state script ran for 1 step
0 asserts passed
final state vector:
  G = 0
  S = 1
  T = 0
  highest = 0.000000
  limit = 50
  n = 1
  open = false
  p = 0.000000
good.ss:
state script ran for 2 steps
2 asserts passed
final state vector:
  G = 10
  S = 1
  T = 10
  highest = 0.000000
  limit = 50
  n = 2
  open = false
  p = 0.000000
failed: a.ss:7:16: error: assert failed after step 8 (G = 70, state Idle) [E0750]
failed: b.ss:4:17: error: assert failed after step 1 (G = 0, state Idle) [E0750]
1 passed, 2 failed
-- stderr --
a.ss:7:16: error: assert failed after step 8 (G = 70, state Idle) [E0750]
    7 | n > 6: @assert (p < limit or highest < 55) and not open and roll_max(p, 3) < G
      |                ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ p = 35, limit = 50, highest = 35, open = true, roll_max(p, 3) = 30, G = 70
note: the last steps, and the values after each:
      step   G  state   p  highest  open  roll_max(p, 3)
         4  30  Idle   15       15  true              10
         5  40  Idle   20       20  true              15
         6  50  Idle   25       25  true              20
         7  60  Idle   30       30  true              25
         8  70  Idle   35       35  true              30
a.sm:16:23: note: transition in step 8 (G = 70): Idle -> Abort
a.sm:13:5: note: step 8 (G = 70): `highest = max(highest, p)` stored 35: highest = 30, p = 35
a.sm:14:5: note: step 8 (G = 70): `open = roll_avg(p, 2) > 5` stored true: roll_avg(p, 2) = 32.5
1 error
a.ss:7:16: error: assert failed after step 8 (G = 70, state Idle) [E0750]
    7 | n > 6: @assert (p < limit or highest < 55) and not open and roll_max(p, 3) < G
      |                ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ p = 35, limit = 50, highest = 35, open = true, roll_max(p, 3) = 30, G = 70
note: the last steps, and the values after each:
      step   G  state   p  highest  open  roll_max(p, 3)
         4  30  Idle   15       15  true              10
         5  40  Idle   20       20  true              15
         6  50  Idle   25       25  true              20
         7  60  Idle   30       30  true              25
         8  70  Idle   35       35  true              30
a.sm:16:23: note: transition in step 8 (G = 70): Idle -> Abort
a.sm:13:5: note: step 8 (G = 70): `highest = max(highest, p)` stored 35: highest = 30, p = 35
a.sm:14:5: note: step 8 (G = 70): `open = roll_avg(p, 2) > 5` stored true: roll_avg(p, 2) = 32.5
1 error
b.ss:4:17: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | p > -1: @assert false
      |                 ^~~~~
note: the step, and the values after it:
      step  G  state  p
         1  0  Idle   0
note: the machine has been in state 'Idle' from the start
1 error
c.ss:8:1: warning: 'G' is never exactly 45: it advances by 10 [W0702 exact-moment]
    8 | G == 45: @stop
      | ^~~~~~~
c.ss:8:10: error: the script did not reach @stop within 1000000 steps [E0751]
    8 | G == 45: @stop
      |          ^~~~~
c.ss:8:10: note: section [Abort] last ran in step 1000000 (G = 9999990), and this condition was never true in it
note: the machine has been in state 'Abort' since step 4 (G = 30)
note: the last steps, and the values after each:
         step        G  state
       999996  9999950  Abort
       999997  9999960  Abort
       999998  9999970  Abort
       999999  9999980  Abort
      1000000  9999990  Abort
a.sm:15:16: note: transition in step 3 (G = 20): Idle -> Abort
1 error, 1 warning
a.ss:7:16: error: assert failed after step 8 (G = 70, state Idle) [E0750]
    7 | n > 6: @assert (p < limit or highest < 55) and not open and roll_max(p, 3) < G
      |                ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ p = 35, limit = 50, highest = 35, open = true, roll_max(p, 3) = 30, G = 70
note: the last steps, and the values after each:
      step   G  state   p  highest  open  roll_max(p, 3)
         4  30  Idle   15       15  true              10
         5  40  Idle   20       20  true              15
         6  50  Idle   25       25  true              20
         7  60  Idle   30       30  true              25
         8  70  Idle   35       35  true              30
a.sm:16:23: note: transition in step 8 (G = 70): Idle -> Abort
a.sm:13:5: note: step 8 (G = 70): `highest = max(highest, p)` stored 35: highest = 30, p = 35
a.sm:14:5: note: step 8 (G = 70): `open = roll_avg(p, 2) > 5` stored true: roll_avg(p, 2) = 32.5
1 error
b.ss:4:17: error: assert failed after step 1 (G = 0, state Idle) [E0750]
    4 | p > -1: @assert false
      |                 ^~~~~
note: the step, and the values after it:
      step  G  state  p
         1  0  Idle   0
note: the machine has been in state 'Idle' from the start
1 error
{"severity":"error","code":"E0750","message":"assert failed after step 8 (G = 70, state Idle)","file":"a.ss","line":7,"column":16,"endLine":7,"endColumn":79,"label":"p = 35, limit = 50, highest = 35, open = true, roll_max(p, 3) = 30, G = 70","notes":[{"message":"the last steps, and the values after each:\u000astep   G  state   p  highest  open  roll_max(p, 3)\u000a   4  30  Idle   15       15  true              10\u000a   5  40  Idle   20       20  true              15\u000a   6  50  Idle   25       25  true              20\u000a   7  60  Idle   30       30  true              25\u000a   8  70  Idle   35       35  true              30","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"step":null},{"message":"transition in step 8 (G = 70): Idle -> Abort","file":"a.sm","line":16,"column":23,"endLine":16,"endColumn":31,"step":null},{"message":"step 8 (G = 70): `highest = max(highest, p)` stored 35: highest = 30, p = 35","file":"a.sm","line":13,"column":5,"endLine":13,"endColumn":30,"step":null},{"message":"step 8 (G = 70): `open = roll_avg(p, 2) > 5` stored true: roll_avg(p, 2) = 32.5","file":"a.sm","line":14,"column":5,"endLine":14,"endColumn":30,"step":null}],"edits":[],"flag":null,"group":null}
-- exit --
1 1 1 1 1 1
