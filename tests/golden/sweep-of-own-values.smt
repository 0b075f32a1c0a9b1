# A script that sets the swept parameter itself keeps its value, and is left out; the current value is that of the machine.  Values of an F32 are the
# shortest decimals that are the same F32.
args sweep b.sm usual.ss own.ss --set burn=1:15:3
args sweep b.sm usual.ss own.ss --set burn=1:15:3 --format=json
args sweep b.sm own.ss --set burn=1:15:3
args sweep b.sm own.ss --set burn=1:15:3 --format=json
args sweep b.sm usual.ss own.ss --set burn=1:15:2 --set wait=0:100:2
args report b.sm usual.ss own.ss --sweep --format=text | sed -n '/^  Parameters/p; /^  Parameter  Verdict/,/^  Check/p'
args report b.sm own.ss --sweep --format=text | sed -n '/^  Parameters/p; /^  Parameter  Verdict/,/^What it costs/p'

-- b.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
bool valve
[local]
F32 burn = 8 @parameter @range 1 15 @unit s
U32 wait = 0 @parameter @range 0 100
[Burn]
.step
    valve = T >= wait
    T >= burn * 1000: -> Done
[Done] @safe
.entry
    valve = false
-- usual.ss --
[all_states]
at 5.9 s: @assert valve
at 9 s: @assert state Done
at 16 s: @stop
-- own.ss --
[options]
set burn 15
[all_states]
at 14.9 s: @assert state Burn
at 16 s: @stop
-- stdout --
sweep of b: 2 scripts, 28 runs
burn:
  left out, with a value of their own: own.ss
  1: fails: usual.ss:2
  8: passes
  15: fails: usual.ss:3
  usual.ss:2: passes from 5.891, fails up to 5.89
  usual.ss:3: passes up to 8.99, fails from 8.991
  now 8: below, fails at 5.89 (2.11 away, only the assert usual.ss:2); above, fails at 8.991 (0.991 away, only the assert usual.ss:3)
{"smc-sweep":1,"machine":"b","runs":28,"complete":true,"parameters":[
{"name":"burn","now":8,"is_swept":true,"is_noticed":true,"fails_now":false,"fails_below":5.89,"check_below":"usual.ss:2","kind_below":"assert","fails_above":8.991,"check_above":"usual.ss:3","kind_above":"assert","left_out":["own.ss"],"values":[{"from":1,"to":1,"fails":["usual.ss:2"]},{"from":8,"to":8,"fails":[]},{"from":15,"to":15,"fails":["usual.ss:3"]}]}],
"points":[
{"at":[1],"fails":["usual.ss:2"]},
{"at":[8],"fails":[]},
{"at":[15],"fails":["usual.ss:3"]}
],"boundaries":[
{"parameter":"burn","check":"usual.ss:2","passes":5.891,"fails":5.89},
{"parameter":"burn","check":"usual.ss:3","passes":8.99,"fails":8.991}
]}
sweep of b: 1 script, 0 runs
burn:
  left out, with a value of their own: own.ss
  no script is left
{"smc-sweep":1,"machine":"b","runs":0,"complete":true,"parameters":[
{"name":"burn","now":8,"is_swept":false,"is_noticed":false,"fails_now":false,"left_out":["own.ss"],"values":[]}],
"points":[
],"boundaries":[
]}
sweep of b: 2 scripts, 40 runs
wait:
  no script or requirement notices any of these values, so none of them tests this parameter
  0 to 100: passes
  now 0: below, nothing notices it down to 0; above, nothing notices it up to 100
burn:
  left out, with a value of their own: own.ss
  1: fails: usual.ss:2
  8: passes
  15: fails: usual.ss:3
  usual.ss:2: passes from 5.891, fails up to 5.89
  usual.ss:3: passes up to 8.99, fails from 8.991
  now 8: below, fails at 5.89 (2.11 away, only the assert usual.ss:2); above, fails at 8.991 (0.991 away, only the assert usual.ss:3)
map: wait up, burn to the right from 1 to 15; '.' passes, a digit is the number of checks that fail, '+' more than 9
  100  11
    0  11
  Parameters    open     1 with a known margin, 1 whose value nothing notices
  Parameter  Verdict         Now  Below                                                  Above
  wait       not noticed     0    nothing notices it down to 0                           nothing notices it up to 100
  burn       only an assert  8    fails at 5.89 (2.11 away, only the assert usual.ss:2)  fails at 8.9901 (0.9901 away, only the assert usual.ss:3)

`burn` from 1 to 15
Left out, because they set the parameter themselves: own.ss.

  From  To   What fails
  1     5.2  usual.ss:2
  5.9   8.7  nothing
  9.4   15   usual.ss:3

  Check       Passes at  Fails at
  Parameters    open     1 whose value nothing notices, 1 that all scripts set themselves
  Parameter  Verdict      Now  Below                         Above
  wait       not noticed  0    nothing notices it down to 0  nothing notices it up to 100
  burn       not changed  8

`burn` from 1 to 15
Not changed, because all scripts set the parameter themselves: own.ss.

`wait` from 0 to 100
  From  To   What fails
  0     100  nothing

What it costs
