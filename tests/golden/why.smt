# smc why: a step, a state that was not reached, a variable, and wrong questions.
args why a.sm a.ss --at 0.09 s
args why a.sm a.ss --at=90 '-> Abort'
args why a.sm a.ss --at-step=10 --to=Idle
args why a.sm a.ss --of=open
args why a.sm a.ss p --at=20
args why a.sm a.ss --to=Abort --format=json
args why a.sm a.ss --at=95
args why a.sm a.ss --at=4s
args why a.sm a.ss --at=0.5ms
args why a.sm a.ss --at=soon
args why a.sm a.ss --to=Abrt
args why a.sm a.ss --of=opn
args why a.sm a.ss open --to=Abort
args why a.sm a.ss -
args why a.sm a.ss '->'
args why a.sm
args why a.sm a.ss b.csv
args why a.sm a.ss --at=1 --at-step=1
args why a.sm a.ss --at-step=0
args why a.sm a.ss --depth=many
args why a.sm a.ss --machine=a

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only
bool open

[Fill]
.step
    open = p > 775
    armed and p > 825: -> Abort

[Abort] @abort @safe
.entry
    open = true
.step
    held(p < 100, 50 ms): -> Idle

[Idle] @safe
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 850
G == 100: armed = true
G == 120: p = 50
G == 150 {
    @assert S == Abort
    @stop
}
-- stdout --
step 10 (G = 90): Fill, entered in step 1 (G = 0); took no transition
  a.sm:12: `open = p > 775` stored true: p = 850
  a.sm:13: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was false since step 1 (G = 0)
    `p > 825` was true since step 1 (G = 0): p = 850
what would have made a difference in this step:
  with armed = true (it was false), the step would have taken the transition to Abort
where the values come from:
  a.sm:7: nothing has written armed, so it has its first value
  a.ss:4: the script wrote p in step 1, by `p = 850`
step 10 (G = 90): Fill, entered in step 1 (G = 0); took no transition
  a.sm:13: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was false since step 1 (G = 0)
    `p > 825` was true since step 1 (G = 0): p = 850
what would have made a difference in this step:
  with armed = true (it was false), the step would have taken the transition to Abort
where the values come from:
  a.sm:7: nothing has written armed, so it has its first value
  a.ss:4: the script wrote p in step 1, by `p = 850`
step 10 (G = 90): Fill, entered in step 1 (G = 0); took no transition
  Fill has no transition to Idle
  a.sm:19: Abort leads to Idle; the machine was never in it
the shortest path is Fill -> Abort -> Idle; its first transition:
  a.sm:13: `armed and p > 825` was false since step 1 (G = 0)
    `armed` was false since step 1 (G = 0)
    `p > 825` was true since step 1 (G = 0): p = 850
what would have made a difference in this step:
  with armed = true (it was false), the step would have taken the transition to Abort
where the values come from:
  a.sm:7: nothing has written armed, so it has its first value
  a.ss:4: the script wrote p in step 1, by `p = 850`
step 16 (G = 150): open = true, last stored in step 12 (G = 110)
step 12 (G = 110): Abort, entered in step 12 (G = 110); took no transition
  a.sm:17: `open = true` was executed
how the machine got there:
  a.sm:13: step 11 (G = 100): Fill -> Abort, because `armed and p > 825` was true: armed = true, p = 850
  the run began in Fill
step 3 (G = 20): p = 850
  a.ss:4: the script wrote p in step 1, by `p = 850`
{"smc-why":1,"step":16,"G":150,"lines":[
{"kind":"step","depth":0,"text":"step 16 (G = 150): Abort, entered in step 12 (G = 110); took no transition","step":16},
{"kind":"remark","depth":0,"text":"the script stopped after this step"},
{"kind":"remark","depth":1,"text":"the machine was in Abort already"},
{"kind":"heading","depth":0,"text":"how the machine got there:"},
{"kind":"passage","depth":1,"text":"step 11 (G = 100): Fill -> Abort, because `armed and p > 825` was true: armed = true, p = 850","file":"a.sm","line":13,"column":24,"step":11},
{"kind":"remark","depth":1,"text":"the run began in Fill"}
]}
-- stderr --
smc: no step has G = 95: its neighbours are G = 90 and G = 100
smc: no step has G = 4000: the script ended in step 16 (G = 150)
smc: --at: '0.5ms' is no whole number of ms, in which G counts
Try 'smc why --help'.
smc: --at requires a time, as in 400, '4 s' or 250ms, not 'soon'
Try 'smc why --help'.
smc: machine 'a' has no state 'Abrt'; did you mean 'Abort'?
Try 'smc why --help'.
smc: machine 'a' has no element or local 'opn'; did you mean 'open'?
Try 'smc why --help'.
smc: one question at a time: 'open' is one more
Try 'smc why --help'.
smc: the shell reads '>' as a redirection: write --to=STATE, or quote the arrow, as in '-> Abort'
Try 'smc why --help'.
smc: a state is required after '->'
Try 'smc why --help'.
smc: a machine and one script are required, as in 'smc why tank.sm tank.ss --at 400'
Try 'smc why --help'.
smc: one script of a machine is explained, as in 'smc why tank.sm tank.ss --at 400', and 'b.csv' is another file
Try 'smc why --help'.
smc: --at and --at-step exclude each other
Try 'smc why --help'.
smc: --at-step requires a whole number from 1, not '0'
Try 'smc why --help'.
smc: --depth requires a whole number from 0 to 1000, not 'many'
Try 'smc why --help'.
smc: --machine is for applications (.app)
Try 'smc why --help'.
-- exit --
0 0 0 0 0 0 1 1 2 2 2 2 2 2 2 2 2 2 2 2 2
