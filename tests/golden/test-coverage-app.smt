# The coverage of an application is that of each of its machines, also added from a file of counts.
args test rocket.app first.ss --coverage --coverage-data=first.cov --coverage-json=c.json --coverage-lcov=c.info && head -n 3 c.json && grep -c SF c.info
args test rocket.app second.ss first.cov --coverage
args test rocket.app first.ss --min-coverage=guards:60
args test rocket.app second.ss first.cov --min-coverage=transitions:100,states:100
args test a.sm second.ss first.cov --coverage

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[flight]
every 10 ms:
    machine a "a.sm"
every 20 ms:
    machine b "b.sm"
-- first.ss --
[all_states]
G == 0: p = 1
G == 60: @assert valve
G == 60: @stop
-- second.ss --
[all_states]
G == 0: p = 1
G == 20: p = 0
G == 60: @assert not valve
G == 60: @stop
-- rocket.sv --
[A]
U64  time
U32  aState
U32  bState
U8   mode
F64  p
bool ready
bool valve
-- a.sm --
[state_vector]
U64  time   @alias G
U32  aState @alias S
F64  p      @read_only
bool ready

[Wait] @safe
.step
    ready = false
    p == 1: -> Go

[Go] @safe
.step
    ready = true
    p == 0: -> Wait
-- b.sm --
[state_vector]
U64  time   @alias G
U32  bState @alias S
bool ready  @read_only
bool valve

[Shut] @safe
.step
    valve = false
    ready: -> Open

[Open] @safe
.step
    valve = true
    not ready: -> Shut
-- stdout --
state script ran for 7 steps
1 assert passed
final state vector:
  a.T = 50
  aState = 2
  b.T = 20
  bState = 2
  mode = 0
  p = 1.000000
  ready = true
  time = 60
  valve = true
coverage of a:
  transitions  1 of 2
  statements   5 of 6
  guards       2 of 4
  conditions   2 of 4
  states       3 of 4
not covered:
  line 10: `p == 1` was never false
  line 12: state Go was never left
  line 15: `p == 0` was never true
coverage of b:
  transitions  1 of 2
  statements   5 of 6
  guards       3 of 4
  conditions   3 of 4
  states       3 of 4
not covered:
  line 12: state Open was never left
  line 15: `not ready` was never true
{"smc-coverage":1,"application":"rocket","machines":[
{"smc-coverage":1,"machine":"a","identity":"d457d41d90320876","file":"a.sm",
"totals":{"transitions":{"covered":1,"possible":2,"impossible":0},"statements":{"covered":5,"possible":6,"impossible":0},"guards":{"covered":2,"possible":4,"impossible":0},"conditions":{"covered":2,"possible":4,"impossible":0},"windows":{"covered":0,"possible":0,"impossible":0},"states":{"covered":3,"possible":4,"impossible":0},"parameters":{"covered":0,"possible":0,"impossible":0}},
2
coverage of a:
  transitions  2 of 2
  statements   6 of 6
  guards       4 of 4
  conditions   4 of 4
  states       4 of 4
coverage of b:
  transitions  2 of 2
  statements   6 of 6
  guards       4 of 4
  conditions   4 of 4
  states       4 of 4
state script ran for 7 steps
1 assert passed
final state vector:
  a.T = 50
  aState = 2
  b.T = 20
  bState = 2
  mode = 0
  p = 1.000000
  ready = true
  time = 60
  valve = true
-- stderr --
a.sm:10:5: error: too few guards are covered: 2 of 4 in 'a', and 60 % are required [E1400]
   10 |     p == 1: -> Go
      |     ^~~~~~
a.sm:10:5: note: `p == 1` was never false
a.sm:15:5: note: `p == 0` was never true
1 error
smc: 'first.cov' has the coverage of another version of 'a': run its scripts again
-- exit --
0 0 1 0 1
