# Each value of a parameter is a place: its default, and both ends of its range. Scripts and --set count alike, and so do counts of other runs.
args test a.sm a.ss --coverage --coverage-data=one.cov -w
args test a.sm a.ss one.cov --set limit=900 --min-coverage=parameters:60 --coverage-json=b.json -w && grep parameters b.json
args test a.sm a.ss one.cov --set limit=900 --set armed=1 --min-coverage=parameters:100 --coverage-lcov=- -w

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[local]
F64  limit = 400 @parameter @range 100 900
bool armed = false @parameter

[Fill]
.step
    open = armed and p > limit

-- a.ss --
[options]
delta_t 10
set limit 100

[all_states]
G == 0: p = 500
G == 10 {
    @assert not open or armed
    @stop
}
-- stdout --
state script ran for 2 steps
1 assert passed
final state vector:
  G = 10
  S = 1
  T = 10
  armed = false
  limit = 100.000000
  open = false
  p = 500.000000
coverage of a:
  statements   1 of 1
  guards       1 of 2
  conditions   1 of 4
  states       1 of 1
  parameters   2 of 5
not covered:
  line 8: parameter `limit` never had its default 400
  line 8: parameter `limit` never had its highest value 900
  line 9: parameter `armed` never had its highest value true
  line 13: `armed and p > limit` was never true
  line 13: `p > limit` was never false while it decided
"totals":{"transitions":{"covered":0,"possible":0,"impossible":0},"statements":{"covered":1,"possible":1,"impossible":0},"guards":{"covered":1,"possible":2,"impossible":0},"conditions":{"covered":1,"possible":4,"impossible":0},"windows":{"covered":0,"possible":0,"impossible":0},"states":{"covered":1,"possible":1,"impossible":0},"parameters":{"covered":3,"possible":5,"impossible":0}},
{"kind":"parameters","line":8,"column":6,"text":"limit","value":400,"count":0},
{"kind":"parameters","line":8,"column":6,"text":"limit","value":100,"count":1},
{"kind":"parameters","line":8,"column":6,"text":"limit","value":900,"count":1},
{"kind":"parameters","line":9,"column":6,"text":"armed","value":false,"count":2},
{"kind":"parameters","line":9,"column":6,"text":"armed","value":true,"count":0}
TN:smc
SF:a.sm
FN:11,Fill
FNDA:2,Fill
FNF:1
FNH:1
BRDA:13,161,0,0
BRDA:13,161,1,4
BRDA:8,68,0,0
BRDA:8,68,1,1
BRDA:8,68,2,1
BRDA:9,111,0,1
BRDA:9,111,1,1
BRF:7
BRH:5
DA:13,4
LF:1
LH:1
end_of_record
-- stderr --
a.sm:8:6: error: too few parameters are covered: 4 of 5, and 100 % are required [E1400]
    8 | F64  limit = 400 @parameter @range 100 900
      |      ^~~~~
a.sm:8:6: note: parameter `limit` never had its default 400
1 error
-- exit --
0 0 1
