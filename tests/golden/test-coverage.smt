# --coverage says which places the scripts test.  --min-coverage fails and lists what is missing.  Counts of several runs are added.
args test a.sm a.ss --coverage -w
args test a.sm a.ss --min-coverage=transitions:40,states:100 --coverage-data=one.cov -w
args test a.sm b.ss one.cov --coverage --min-coverage=transitions:75,states:100,conditions:60 -w
args test a.sm one.cov --coverage-data=one.cov -w
args test a.sm one.cov --coverage-data=two.cov -w && cmp one.cov two.cov && cat two.cov
args test a.sm b.ss --coverage-lcov=- -w
args test a.sm b.ss --coverage-json=b.json --tap --min-coverage=windows:100 -w && head -n 5 b.json
args test other.sm other.ss one.cov --coverage -w
args test a.sm a.ss a2.cov --coverage -w
args test a.sm a.ss a3.cov --coverage -w
args test a.sm a.ss a4.cov --coverage -w
args test a.sm a.ss --min-coverage=transition:100 -w
args test a.sm a.ss --min-coverage=guards:101 -w
args test a.sm a.ss one.cov -w
args test cases --coverage -w

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[local]
U8 n = 0

[define]
high = p > 400 and held(p > 300, 2 steps)

[all_states] @except Abort
.step
    p > 900: -> Abort

[Fill]
.step
    open = p > 100 or n > 200
    high and n >= 0: -> Hold

[Hold]
.entry
    n = n + 1
.step
    roll_avg(p, 5) < 50: -> Fill

[Abort] @abort @safe
.entry
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 350
G == 20: p = 450
G == 50 {
    @assert open
    @stop
}
-- b.ss --
[options]
delta_t 10
[all_states]
G == 20: p = 450
G == 40: p = 0
G == 200: p = 1000
G == 300 {
    @assert open
    @stop
}
-- other.sm --
[state_vector]
U64 G
U32 S
[A]
-- other.ss --
[options]
delta_t 10
[all_states]
true: @assert S == A
G == 10: @stop
-- a2.cov --
smc-coverage 1
machine a 0000000000000000
places 3
1
1
1
-- a3.cov --
{}
-- a4.cov --
smc-coverage 1
machine a
-- cases/one.smt --
\-- a.sm --
[state_vector]
U64 G
U32 S
[A]
-- stdout --
state script ran for 6 steps
1 assert passed
final state vector:
  G = 50
  S = 2
  T = 20
  n = 1
  open = true
  p = 450.000000
coverage of a:
  transitions  1 of 4
  statements   6 of 9
  guards       6 of 10
  conditions   8 of 15, and 1 impossible
  windows      1 of 1
  states       3 of 5
not covered:
  line 11: `p > 300` was never false
  line 15: `p > 900` was never true
  line 19: `p > 100 or n > 200` was never false
  line 19: `n > 200` was never true while it decided
  line 20: `held(p > 300, 2 steps)` of `high` was never false while it decided
  line 22: state Hold was never left
  line 26: `roll_avg(p, 5) < 50` was never true
  line 28: state Abort was never entered
impossible:
  line 20: `n >= 0` was never false while it decided: `n` is from 0 to 255
state script ran for 6 steps
1 assert passed
final state vector:
  G = 50
  S = 2
  T = 20
  n = 1
  open = true
  p = 450.000000
coverage of a:
  transitions  3 of 4
  statements   9 of 9
  guards       10 of 10
  conditions   14 of 15, and 1 impossible
  windows      1 of 1
  states       5 of 5
not covered:
  line 15: `-> Abort` was never taken from Hold
  line 19: `n > 200` was never true while it decided
impossible:
  line 20: `n >= 0` was never false while it decided: `n` is from 0 to 255
smc-coverage 1
machine a aabebaf07e0b4bbd
places 45
6
0
6
0
1
1
6
0
6
0
6
0
0
3
3
0
1
0
0
0
3
1
2
1
1
1
0
1
0
1
1
1
0
1
0
3
0
3
0
2
1
0
0
0
0
TN:smc
SF:a.sm
FN:17,Fill
FN:22,Hold
FN:28,Abort
FNDA:2,Fill
FNDA:1,Hold
FNDA:1,Abort
FNF:3
FNH:3
BRDA:11,106,0,13
BRDA:11,106,1,18
BRDA:15,162,0,1
BRDA:15,162,1,20
BRDA:19,205,0,2
BRDA:19,205,1,13
BRDA:20,228,0,1
BRDA:20,228,1,14
BRDA:26,292,0,1
BRDA:26,292,1,4
BRF:10
BRH:10
DA:15,21
DA:19,15
DA:20,15
DA:24,1
DA:26,5
DA:30,1
LF:6
LH:6
end_of_record
TAP version 13
1..2
ok 1 - b.ss
ok 2 - coverage of a.sm
{"smc-coverage":1,"machine":"a","identity":"aabebaf07e0b4bbd","file":"a.sm",
"totals":{"transitions":{"covered":3,"possible":4,"impossible":0},"statements":{"covered":9,"possible":9,"impossible":0},"guards":{"covered":10,"possible":10,"impossible":0},"conditions":{"covered":13,"possible":15,"impossible":1},"windows":{"covered":1,"possible":1,"impossible":0},"states":{"covered":5,"possible":5,"impossible":0},"parameters":{"covered":0,"possible":0,"impossible":0}},
"places":[
{"kind":"guards","line":11,"column":25,"text":"p > 300","outcome":true,"count":13},
{"kind":"guards","line":11,"column":25,"text":"p > 300","outcome":false,"count":18},
-- stderr --
a.sm:15:14: error: too few transitions are covered: 1 of 4, and 40 % are required [E1400]
   15 |     p > 900: -> Abort
      |              ^~~~~~~~
a.sm:15:14: note: `-> Abort` was never taken from Fill and Hold
a.sm:26:26: note: `-> Fill` was never taken from Hold
a.sm:22:2: error: too few states are covered: 3 of 5, and 100 % are required [E1400]
   22 | [Hold]
      |  ^~~~
a.sm:22:2: note: state Hold was never left
a.sm:28:2: note: state Abort was never entered
2 errors
smc: 'one.cov' is an input of this command and cannot be its output; name another file after --coverage-data
Try 'smc test --help'.
state script ran for 31 steps
1 assert passed
final state vector:
  G = 300
  S = 3
  T = 90
  n = 1
  open = true
  p = 1000.000000
smc: 'one.cov' has the coverage of the machine 'a', not of 'other'
smc: 'a2.cov' has the coverage of another version of 'a': run its scripts again
smc: 'a3.cov' is no file that --coverage-data has written
smc: 'a4.cov' is damaged: the name of its machine is missing
smc: --min-coverage requires kinds and percentages, as in transitions:100,conditions:90; the kinds are transitions, statements, guards, conditions, windows, states, parameters and requirements
Try 'smc test --help'.
smc: --min-coverage requires kinds and percentages, as in transitions:100,conditions:90; the kinds are transitions, statements, guards, conditions, windows, states, parameters and requirements
Try 'smc test --help'.
smc: a file of counts (.cov) requires a machine and --coverage
Try 'smc test --help'.
smc: coverage is measured of a machine and its scripts, not of .smt cases
Try 'smc test --help'.
-- exit --
0 1 0 2 0 0 0 1 1 1 1 2 2 2 2
