# --traceability lists both directions: requirements to places and asserts, and parts of the machine, scripts and asserts to requirements.
# Texts that a spreadsheet would take for a formula are made harmless.  Ids that only marks and asserts name are requirements, too.
args test a.sm a.ss bad.ss a.rq --traceability=t.csv -w; tr -d '\015' <t.csv
args test a.sm a.ss a.rq --traceability=t.json -w | tail -n 1; cat t.json
args test a.sm a.ss --traceability=- 2>log | tr -d '\015'; tail -n 1 log
args test a.sm a.ss a.rq --min-coverage=requirements:70 -w >log; tail -n 1 log
args test a.sm a.ss a.rq --min-coverage=requirements:10 -w >log; tail -n 1 log
args test a.sm a.ss --min-coverage=requirements:10
args test case.smt --traceability=t.csv
args test x.app a.ss --traceability=t.csv
args test a.sm a.ss --min-coverage=requirement:10

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open
bool horn
[all_states] @req R6
@except Abort
.step
    p < -1: -> Abort
[Fill]
.step
    if p > 700 {
        open = true @req R1
        horn = p > 800
    } @req R2
    -p > 5 and T > 100: -> Hold
    p > 900: -> Abort @req R1 @req R4
[Hold]
[Abort] @abort @safe
.entry
    horn = true
-- a.rq --
R1 "opens, soon"     always p > 750 implies open
R2 "=1+1"             never horn and not open
R3 "@never judged"    never Fill after Hold without Abort
-- a.ss --
[all_states]
G == 0:  @assert not open "-closed"
G == 10: p = 810
G == 20: @assert open @req R4
G == 20: @expect horn within 0 ms
p > 5000: @fail "too high" @req R1
G == 30 {
    @stop
}
G == 30: p = 950
-- bad.ss --
[all_states]
G == 20: @assert open "never" @req R1
G == 30: @stop
-- case.smt --
-- x.app --
-- stdout --
1 passed, 1 failed
requirements:
  R1  met           opens, soon
      judged in a.ss: 3
      tested by a.ss:6, bad.ss:2 (failed)
      implemented in a.sm:16, a.sm:20
  R2  met           =1+1
      judged in a.ss: 4, bad.ss: 3
      implemented in a.sm:18
  R3  never judged  @never judged
      no script came to Hold, Abort
      implemented nowhere
5 requirements: 2 tested, 1 violated, 2 untested; 1 transition, 1 output, 2 states without a requirement
kind,name,text,place,requirements,by,implemented,asserts,scripts,times,result,proof
requirement,R1,"opens, soon",a.rq:1,,,"Fill: open = true (a.sm:16); Fill -> Abort (a.sm:20)","a.ss:6 (passed); bad.ss:2 (failed)",a.ss (3),3,violated,not tried
requirement,R2,'=1+1,a.rq:2,,,Fill: if p > 700 (a.sm:18),,"a.ss (4); bad.ss (3)",7,tested,not tried
requirement,R3,'@never judged,a.rq:3,,,,,,0,untested,not tried
requirement,R6,,,,,all states except Abort (a.sm:9),,,0,untested,not tried
requirement,R4,,,,,Fill -> Abort (a.sm:20),a.ss:4 (passed),,0,tested,not tried
all_states,all states except Abort,,a.sm:9,R6,itself,,,,,,
transition,all states except Abort -> Abort,p < -1,a.sm:12,R6,state,,,,,,
state,Fill,,a.sm:13,"R1; R2; R4",contents,,,,,,
output,Fill: open,open = true,a.sm:16,"R1; R2",itself,,,,,,
output,Fill: horn,horn = p > 800,a.sm:17,R2,conditional,,,,,,
transition,Fill -> Hold,'-p > 5 and T > 100,a.sm:19,,,,,,,,
transition,Fill -> Abort,p > 900,a.sm:20,"R1; R4",itself,,,,,,
state,Hold,,a.sm:21,,,,,,,,
state,Abort,,a.sm:22,,,,,,,,
output,Abort: horn,horn = true,a.sm:24,,,,,,,,
script,a.ss,,,"R1; R2; R4",,,,,,passed,
script,bad.ss,,,"R2; R1",,,,,,failed,
assert,a.ss:2,'-closed,a.ss:2,,,,,a.ss,1,passed,
assert,a.ss:4,open,a.ss:4,R4,,,,a.ss,1,passed,
assert,a.ss:5,horn,a.ss:5,,,,,a.ss,1,passed,
assert,a.ss:6,too high,a.ss:6,R1,,,,a.ss,0,passed,
assert,bad.ss:2,never,bad.ss:2,R1,,,,bad.ss,1,failed,
5 requirements: 3 tested, 2 untested; 1 transition, 1 output, 2 states without a requirement
{"smc-traceability":1,"machine":"a","tested":3,"violated":0,"undecided":0,"untested":2,"without":{"state":2,"all_states":0,"transition":1,"output":1},
"requirements":[
{"id":"R1","text":"opens, soon","file":"a.rq","line":1,"implemented":[{"file":"a.sm","line":16,"name":"Fill: open = true"},{"file":"a.sm","line":20,"name":"Fill -> Abort"}],"asserts":[3],"judged":[{"script":"a.ss","steps":3}],"steps":3,"unvisited":"","result":"tested","proof":"not tried"},
{"id":"R2","text":"=1+1","file":"a.rq","line":2,"implemented":[{"file":"a.sm","line":18,"name":"Fill: if p > 700"}],"asserts":[],"judged":[{"script":"a.ss","steps":4}],"steps":4,"unvisited":"","result":"tested","proof":"not tried"},
{"id":"R3","text":"@never judged","file":"a.rq","line":3,"implemented":[],"asserts":[],"judged":[],"steps":0,"unvisited":"Hold, Abort","result":"untested","proof":"not tried"},
{"id":"R6","text":null,"implemented":[{"file":"a.sm","line":9,"name":"all states except Abort"}],"asserts":[],"judged":[],"steps":0,"unvisited":"","result":"untested","proof":"not tried"},
{"id":"R4","text":null,"implemented":[{"file":"a.sm","line":20,"name":"Fill -> Abort"}],"asserts":[1],"judged":[],"steps":0,"unvisited":"","result":"tested","proof":"not tried"}],
"parts":[
{"kind":"all_states","where":"all states except Abort","name":"all states except Abort","text":"","file":"a.sm","line":9,"requirements":["R6"],"by":"itself"},
{"kind":"transition","where":"all states except Abort","name":"all states except Abort -> Abort","text":"p < -1","file":"a.sm","line":12,"requirements":["R6"],"by":"state"},
{"kind":"state","where":"Fill","name":"Fill","text":"","file":"a.sm","line":13,"requirements":["R1","R2","R4"],"by":"contents"},
{"kind":"output","where":"Fill","name":"Fill: open","text":"open = true","file":"a.sm","line":16,"requirements":["R1","R2"],"by":"itself"},
{"kind":"output","where":"Fill","name":"Fill: horn","text":"horn = p > 800","file":"a.sm","line":17,"requirements":["R2"],"by":"conditional"},
{"kind":"transition","where":"Fill","name":"Fill -> Hold","text":"-p > 5 and T > 100","file":"a.sm","line":19,"requirements":[],"by":""},
{"kind":"transition","where":"Fill","name":"Fill -> Abort","text":"p > 900","file":"a.sm","line":20,"requirements":["R1","R4"],"by":"itself"},
{"kind":"state","where":"Hold","name":"Hold","text":"","file":"a.sm","line":21,"requirements":[],"by":""},
{"kind":"state","where":"Abort","name":"Abort","text":"","file":"a.sm","line":22,"requirements":[],"by":""},
{"kind":"output","where":"Abort","name":"Abort: horn","text":"horn = true","file":"a.sm","line":24,"requirements":[],"by":""}],
"scripts":[
{"name":"a.ss","result":"passed","requirements":["R1","R2","R4"]}],
"asserts":[
{"kind":"assert","file":"a.ss","line":2,"script":"a.ss","text":"-closed","requirement":null,"evaluated":1,"result":"passed"},
{"kind":"assert","file":"a.ss","line":4,"script":"a.ss","text":"open","requirement":"R4","evaluated":1,"result":"passed"},
{"kind":"expect","file":"a.ss","line":5,"script":"a.ss","text":"horn","requirement":null,"evaluated":1,"result":"passed"},
{"kind":"fail","file":"a.ss","line":6,"script":"a.ss","text":"too high","requirement":"R1","evaluated":0,"result":"passed"}]}
kind,name,text,place,requirements,by,implemented,asserts,scripts,times,result,proof
requirement,R6,,,,,all states except Abort (a.sm:9),,,0,untested,not tried
requirement,R1,,,,,"Fill: open = true (a.sm:16); Fill -> Abort (a.sm:20)",a.ss:6 (passed),,0,tested,not tried
requirement,R2,,,,,Fill: if p > 700 (a.sm:18),,,0,untested,not tried
requirement,R4,,,,,Fill -> Abort (a.sm:20),a.ss:4 (passed),,0,tested,not tried
all_states,all states except Abort,,a.sm:9,R6,itself,,,,,,
transition,all states except Abort -> Abort,p < -1,a.sm:12,R6,state,,,,,,
state,Fill,,a.sm:13,"R1; R2; R4",contents,,,,,,
output,Fill: open,open = true,a.sm:16,"R1; R2",itself,,,,,,
output,Fill: horn,horn = p > 800,a.sm:17,R2,conditional,,,,,,
transition,Fill -> Hold,'-p > 5 and T > 100,a.sm:19,,,,,,,,
transition,Fill -> Abort,p > 900,a.sm:20,"R1; R4",itself,,,,,,
state,Hold,,a.sm:21,,,,,,,,
state,Abort,,a.sm:22,,,,,,,,
output,Abort: horn,horn = true,a.sm:24,,,,,,,,
script,a.ss,,,"R4; R1",,,,,,passed,
assert,a.ss:2,'-closed,a.ss:2,,,,,a.ss,1,passed,
assert,a.ss:4,open,a.ss:4,R4,,,,a.ss,1,passed,
assert,a.ss:5,horn,a.ss:5,,,,,a.ss,1,passed,
assert,a.ss:6,too high,a.ss:6,R1,,,,a.ss,0,passed,
4 requirements: 2 tested, 2 untested; 1 transition, 1 output, 2 states without a requirement
5 requirements: 3 tested, 2 untested; 1 transition, 1 output, 2 states without a requirement
5 requirements: 3 tested, 2 untested; 1 transition, 1 output, 2 states without a requirement
-- stderr --
bad.ss:2:18: error: assert failed after step 3 (G = 20, state Fill): never (R1) [E0750]
    2 | G == 20: @assert open "never" @req R1
      |                  ^~~~ open = false
note: the last steps, and the values after each:
      step   G  state   open
         1   0  Fill   false
         2  10  Fill   false
         3  20  Fill   false
note: the machine has been in state 'Fill' from the start
note: no step has stored open
1 error
a.rq:3:1: error: too few requirements are covered: 3 of 5, and 70 % are required [E1400]
    3 | R3 "@never judged"    never Fill after Hold without Abort
      | ^~
a.rq:3:1: note: R3 is untested: @never judged
a.sm:9:19: note: R6 is untested
1 error
smc: --min-coverage=requirements requires a machine and a file of requirements (.rq)
Try 'smc test --help'.
smc: --traceability requires a machine and its scripts
Try 'smc test --help'.
smc: --traceability requires one machine, and 'x.app' is an application
Try 'smc test --help'.
smc: --min-coverage requires kinds and percentages, as in transitions:100,conditions:90; the kinds are transitions, statements, guards, conditions, windows, states, parameters and requirements
Try 'smc test --help'.
-- exit --
0 0 0 0 0 2 2 2 2
