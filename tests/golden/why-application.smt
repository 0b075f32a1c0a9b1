# An application: the machine of the question, machines with other periods, and names that no machine or several have.
args why x.app a.ss --to=Open
args why x.app a.ss --to=Abort
args why x.app a.ss --machine=tank --at-step=4
args why x.app a.ss pressure
args why x.app a.ss valve --at=70
args why x.app a.ss --machine=drain --to=Idle --format=json
args why x.app a.ss
args why x.app a.ss --to=Wait
args why x.app a.ss --to=Opn
args why x.app a.ss --to=Elsewhere
args why x.app a.ss presure
args why x.app a.ss --machine=tnk
args why x.app a.ss --machine=tank --to=Open
args why x.app a.ss --machine=tank --to=valve
args why x.app a.ss --machine=tank --of=Abort
args why x.app a.ss --machine=tank --to=Elsewhere
args why x.app a.ss --machine=tank --of=elsewhere
args why x.app a.ss --to=Open --at-step=4000
args why x.app a.ss --to=Open --at='4 s'
args why late.app late.ss --machine=tank --at=100

-- x.sv --
[V]
U64 time
F64 pressure
bool valve
U32 tankMode
U32 drainMode
-- x.app --
[options]
state_vector "x.sv"
time time 1 ms
[start]
tankMode = 1
drainMode = 1
[flight]
every 10 ms:
    machine tank "tank.sm"
every 20 ms:
    machine drain "drain.sm"
-- late.app --
[options]
state_vector "x.sv"
time time 1 ms
[start]
time = 500
tankMode = 1
[flight]
every 10 ms:
    machine tank "tank.sm"
-- late.ss --
[all_states]
G == 600: @stop
-- tank.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 tankMode @alias S
F64 pressure @read_only
bool valve
[Wait]
.step
    valve = pressure > 8
    pressure > 12: -> Abort
[Abort] @abort @safe
-- drain.sm --
[options]
step 20 ms
[state_vector]
U64 time @alias G
U32 drainMode @alias S
F64 pressure @read_only
bool valve @read_only
[Wait]
.step
    valve and pressure > 10: -> Open
[Open]
.step
    T > 1000: -> Idle
[Idle] @safe
-- a.ss --
[all_states]
G == 0: pressure = 1
G == 30: pressure = 11
G == 40: pressure = 9.5
G == 60: pressure = 3
G == 100: @stop
-- stdout --
step 11 (G = 100): drain ran Wait, entered in step 1 (G = 0); took no transition
the script stopped after this step
  drain.sm:10: `valve and pressure > 10` was false since step 1 (G = 0)
    `valve` was false since step 7 (G = 60)
    `pressure > 10` was false since step 1 (G = 0): pressure = 3, needs more than 7 more
drain.sm:10: Wait -> Open was never taken; step 5 (G = 40) was nearest to taking it:
  drain.sm:10: `valve and pressure > 10` was false since step 1 (G = 0)
    `valve` was true, since this step
    `pressure > 10` was false since step 1 (G = 0): pressure = 9.5, needs more than 0.5 more
  what would have made a difference in this step:
    with pressure just above 10 (it was 9.5), the step would have taken the transition to Open
where the values come from:
  tank.sm:10: valve was last stored in step 11 (G = 100), by `valve = pressure > 8`
  a.ss:5: the script wrote pressure in step 7, by `pressure = 3`
step 11 (G = 100): tank ran Wait, entered in step 1 (G = 0); took no transition
the script stopped after this step
  tank.sm:11: `pressure > 12` was false since step 1 (G = 0): pressure = 3, needs more than 9 more
what would have made a difference in this step:
  with pressure just above 12 (it was 3), the step would have taken the transition to Abort
tank.sm:11: Wait -> Abort was never taken; step 4 (G = 30) was nearest to taking it:
  tank.sm:11: `pressure > 12` was false since step 1 (G = 0): pressure = 11, needs more than 1 more
  what would have made a difference in this step:
    with pressure just above 12 (it was 11), the step would have taken the transition to Abort
where the values come from:
  a.ss:5: the script wrote pressure in step 7, by `pressure = 3`
step 4 (G = 30): tank ran Wait, entered in step 1 (G = 0); took no transition
  tank.sm:10: `valve = pressure > 8` stored true: pressure = 11
  tank.sm:11: `pressure > 12` was false since step 1 (G = 0): pressure = 11, needs more than 1 more
what would have made a difference in this step:
  with pressure just above 12 (it was 11), the step would have taken the transition to Abort
where the values come from:
  a.ss:3: the script wrote pressure in step 4, by `pressure = 11`
step 11 (G = 100): pressure = 3
  a.ss:5: the script wrote pressure in step 7, by `pressure = 3`
step 8 (G = 70): valve = false, last stored in this step
step 8 (G = 70): tank ran Wait, entered in step 1 (G = 0); took no transition
  tank.sm:10: `pressure > 8` was false since step 7 (G = 60): pressure = 3, needs more than 5 more
  tank.sm:10: `valve = pressure > 8` stored false: pressure = 3
what would have made a difference in this step:
  with pressure just above 8 (it was 3), valve would have become true
where the values come from:
  a.ss:5: the script wrote pressure in step 7, by `pressure = 3`
{"smc-why":1,"step":11,"G":100,"lines":[
{"kind":"step","depth":0,"text":"step 11 (G = 100): drain ran Wait, entered in step 1 (G = 0); took no transition","step":11},
{"kind":"remark","depth":0,"text":"the script stopped after this step"},
{"kind":"remark","depth":1,"text":"Wait has no transition to Idle"},
{"kind":"remark","depth":1,"text":"Open leads to Idle; the machine was never in it","file":"drain.sm","line":13,"column":15},
{"kind":"heading","depth":0,"text":"the shortest path is Wait -> Open -> Idle; its first transition:"},
{"kind":"guard","depth":1,"text":"`valve and pressure > 10` was false since step 1 (G = 0)","file":"drain.sm","line":10,"column":5,"value":false,"since":1},
{"kind":"condition","depth":2,"text":"`valve` was false since step 7 (G = 60)","value":false,"since":7},
{"kind":"condition","depth":2,"text":"`pressure > 10` was false since step 1 (G = 0): pressure = 3, needs more than 7 more","value":false,"gap":7,"since":1},
{"kind":"remark","depth":0,"text":"the machine was never in a state from which a transition leads to Idle"},
{"kind":"nearest","depth":0,"text":"Wait -> Open was never taken; step 5 (G = 40) was nearest to taking it:","file":"drain.sm","line":10,"column":30,"step":5},
{"kind":"guard","depth":1,"text":"`valve and pressure > 10` was false since step 1 (G = 0)","file":"drain.sm","line":10,"column":5,"value":false,"since":1},
{"kind":"condition","depth":2,"text":"`valve` was true, since this step","value":true,"since":5},
{"kind":"condition","depth":2,"text":"`pressure > 10` was false since step 1 (G = 0): pressure = 9.5, needs more than 0.5 more","value":false,"gap":0.5,"since":1},
{"kind":"heading","depth":1,"text":"what would have made a difference in this step:"},
{"kind":"change","depth":2,"text":"with pressure just above 10 (it was 9.5), the step would have taken the transition to Open","variable":"pressure","value":"10.000000000000002","was":"9.5","whole_run":false,"transition":"Open"},
{"kind":"heading","depth":0,"text":"where the values come from:"},
{"kind":"origin","depth":1,"text":"valve was last stored in step 11 (G = 100), by `valve = pressure > 8`","file":"tank.sm","line":10,"column":5,"step":11},
{"kind":"origin","depth":1,"text":"the script wrote pressure in step 7, by `pressure = 3`","file":"a.ss","line":5,"column":10,"step":7}
]}
-- stderr --
smc: 'x.app' has several machines: name one with --machine; they are tank, drain
Try 'smc why --help'.
smc: 'Wait' belongs to several machines: name one with --machine; they are tank, drain
Try 'smc why --help'.
smc: no machine of 'x.app' has the state 'Opn'; did you mean 'Open'?
Try 'smc why --help'.
smc: no machine of 'x.app' has the state 'Elsewhere'
Try 'smc why --help'.
smc: no machine of 'x.app' has the element or local 'presure'; did you mean 'pressure'?
Try 'smc why --help'.
smc: 'x.app' has no machine 'tnk'; its machines are tank, drain
Try 'smc why --help'.
smc: machine 'tank' has no state 'Open'; its states are Wait, Abort
Try 'smc why --help'.
smc: 'valve' is an element or local of machine 'tank', and no state: write --of=valve
Try 'smc why --help'.
smc: 'Abort' is a state of machine 'tank', and no element or local: write --to=Abort
Try 'smc why --help'.
smc: machine 'tank' has no state 'Elsewhere'; its states are Wait, Abort
Try 'smc why --help'.
smc: machine 'tank' has no element or local 'elsewhere'
Try 'smc why --help'.
smc: there is no step 4000: the script ended in step 11 (G = 100)
smc: no step has G = 4000: the script ended in step 11 (G = 100)
smc: no step has G = 100: the first step has G = 500
-- exit --
0 0 0 0 0 0 2 2 2 2 2 2 2 2 2 2 2 1 1 1
