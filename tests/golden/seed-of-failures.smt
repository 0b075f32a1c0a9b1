# Failures of scripts with random numbers name the seed: recorded values that differ, and a requirement that several scripts violate.
args test a.sm c.ss --seed=7
args test a.sm d.ss e.ss a.rq -w

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 x @read_only
bool on
[A] @safe
.step
    on = x > 5
-- d.csv --
t,on
0,1
-- c.ss --
[options]
seed 5
[data]
file "d.csv"
time "t" ms
@compare on "on"
[all_states]
true: x = random(0, 1)
at 0: @stop
-- d.ss --
[options]
seed 5
[all_states]
true: x = 1 + noise(0)
at 0: @stop
-- e.ss --
[options]
seed 6
[all_states]
true: x = 2 + noise(0)
at 0: @stop
-- a.rq --
R1 "x is high" always x > 3
-- stdout --
failed: d.ss: a.rq:1:23: error: requirement R1 violated in step 1 (G = 0, state A): x is high [E1310]
failed: e.ss: a.rq:1:23: error: requirement R1 violated in step 1 (G = 0, state A): x is high [E1310]
0 passed, 2 failed
requirements:
  R1  violated  x is high
      judged in d.ss: 1, e.ss: 1
-- stderr --
c.ss:6:13: error: 'on' differs from column 'on' in 1 of 1 steps [E0781]
    6 | @compare on "on"
      |             ^~~~ first at G = 0, row 1 (d.csv:2): false, recorded true
note: they differ at G = 0
note: the random numbers have seed 7
1 error
a.rq:1:23: error: requirement R1 violated in step 1 (G = 0, state A): x is high [E1310]
    1 | R1 "x is high" always x > 3
      |                       ^~~~~ x = 1
d.ss:1:1: note: this script ran
note: the step, and the values after it:
      step  G  state  x
         1  0  A      1
note: the machine has been in state 'A' from the start
note: the random numbers have seed 5
1 error
a.rq:1:23: error: requirement R1 violated in step 1 (G = 0, state A): x is high [E1310]
    1 | R1 "x is high" always x > 3
      |                       ^~~~~ x = 2
e.ss:1:1: note: this script ran; its steps are printed if it runs alone
note: the random numbers have seed 6
1 error
-- exit --
1 1
