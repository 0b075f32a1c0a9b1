# smc cover of an application: scripts set what no machine writes, and run all machines.  Then what only the application can reach: a value that
# another machine stores in an element of this one, one of [start], a machine whose @mode is off for a while; and what none of its machines writes,
# which is not found, because facts about one machine do not exclude it.  In guard.app, the work goes on only if another machine finds no sensor that
# sticks, so that all of them have to tremble meanwhile.
args cover stand.app -o made && cat made/stand-pump-3-on-to-off.ss && "$SMC" test stand.app made/*.ss --min-coverage=transitions:100,conditions:100
args cover stand.app -o made
args cover stand.app made/*.ss -o none --goals=transitions --format=json
args cover stand.app -o made && echo "# mine" >>made/stand-pump-3-on-to-off.ss && "$SMC" cover stand.app -o made
args cover together.app -o joint --goals=transitions --effort=20
args cover guard.app -o guard --goals=transitions --effort=2 && tail -n 17 guard/*done*
args cover stand.app alone.ss -o none
args cover stand.app fails.ss -o none
args cover broken.app -o none
args cover fractions.app -o none
args cover late.app -o none
args cover stand.app -o made --step=10
args cover stand.app -o made --must-not
args cover stand.app -o made --sv stand.sv
args cover stand.app together.app -o made

-- stand.sv --
[A]
U64  time
U32  pumpState
U32  valveState
U32  counterState
U32  setterState
U32  slowState
bool start @command
F64  level @range 0 10
bool ask
bool open
U16  count
U8   mode
bool never
U8   stage
-- pump.sm --
[state_vector]
U64  time      @alias G
U32  pumpState @alias S
bool start     @read_only
bool open      @read_only
bool ask

[Off] @safe
.step
    ask = false
    start: -> Asking

[Asking]
.step
    ask = true
    open: -> On

[On]
.step
    not start: -> Off
-- valve.sm --
[state_vector]
U64  time       @alias G
U32  valveState @alias S
F64  level      @read_only @range 0 10
bool ask        @read_only
bool open

[Closed] @safe
.step
    open = false
    ask and level > 2: -> Open

[Open]
.step
    open = true
    not ask: -> Closed
-- stand.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine pump "pump.sm"
every 20 ms:
    machine valve "valve.sm"
-- counter.sm --
[state_vector]
U64  time  @alias G
U32  counterState @alias S
U16  count
bool never @read_only
U8   stage

[Begin] @safe
.step
    count == 5 and stage == 3: -> Started

[Started]
.step
    count = 0
    stage = 0
    -> Run

[Run]
.step
    count = 1
    -> Wait

[Wait]
.step
    count > 7: -> Full
    never: -> Broken

[Full]
[Broken]
-- setter.sm --
[state_vector]
U64  time  @alias G
U32  setterState @alias S
U16  count
bool start @read_only
bool never

[Set] @safe
.step
    never = false
    start: count = 9
-- slow.sm --
[state_vector]
U64  time  @alias G
U32  slowState @alias S

[local]
U16 n = 0

[Count] @safe
.step
    n = n + 1
    T > 1 s: -> Judge

[Judge]
.step
    n < 20: -> Early

[Early]
-- together.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[start]
count = 5
stage = 3

[all]
every 10 ms:
    machine counter "counter.sm"
    machine setter  "setter.sm"
    machine slow    "slow.sm" @mode mode
-- guard.sv --
[A]
U64  time
U32  watchState
U32  workState
F32  a @range 0 10
F32  b @range 0 10
F32  c @range 0 10
U8   fault
-- watch.sm --
[state_vector]
U64  time       @alias G
U32  watchState @alias S
F32  a          @read_only @range 0 10
F32  b          @read_only @range 0 10
F32  c          @read_only @range 0 10
U8   fault

[local]
U8 found = 0

[Watch] @safe
.step
    if T > 200 ms and roll_range(a, 10) == 0: found = 1
    else if T > 200 ms and roll_range(b, 10) == 0: found = 2
    else if T > 200 ms and (roll_range(c, 10) == 0 or c > 5): found = 3
    fault = found
-- work.sm --
[state_vector]
U64  time      @alias G
U32  workState @alias S
U8   fault     @read_only

[Work] @safe
.step
    T >= 1 s and fault == 0: -> Done

[Done]
-- guard.app --
[options]
state_vector "guard.sv"
time         time 1 ms

[all]
every 10 ms:
    machine watch "watch.sm"
    machine work  "work.sm"
-- fractions.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[all]
every 500 us:
    task a
every 10 ms:
    machine pump "pump.sm"
-- late.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[start]
time = 10

[all]
every 10 ms:
    machine pump "pump.sm"
-- broken.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[all]
every 10 ms:
    machine pump "broken.sm"
-- broken.sm --
[state_vector]
U64  time      @alias G
U32  pumpState @alias S

[Off] @safe
.step
    start: -> On
-- alone.ss --
[Off]
T == 0: start = true
T == 0: @stop
-- fails.ss --
[all_states]
G == 0: @assert not state pump.Off
G == 10: @stop
-- stdout --
goals of pump: 29 of 29 reached
goals of valve: 22 of 22 reached
wrote made/stand-pump-1-off-to-asking.ss: pump: Off -> Asking, taken because start.
wrote made/stand-pump-guard-2-off-false.ss: pump: In Off, 'start' is false.
wrote made/stand-pump-2-asking-to-on.ss: pump: Asking -> On, taken because open.
wrote made/stand-pump-3-on-to-off.ss: pump: On -> Off, taken because not start.
wrote made/stand-valve-2-open-to-closed.ss: valve: Open -> Closed, taken because not ask.
# Generated by smc cover from stand.app (form 1, checksum 3804ac2e). A changed script is not overwritten.
# pump: On -> Off, taken because not start.
#
# The asserts show what the machine does, not what it should do: check them before you rely on them.

[all_states]
at 0 {
    start = true
    level = 10
}
at 0:                @assert state pump.Off and state valve.Closed and not ask and not open
at 10 ms:            start = false
from 10 ms to 40 ms: @assert state pump.Asking and state valve.Closed and ask and not open
from 40 ms to 60 ms: @assert state pump.Asking and state valve.Open and ask and open
at 60 ms:            @assert state pump.On and state valve.Open and ask and open
at 70 ms:            @assert state pump.Off and state valve.Open and not ask and open
at 70 ms:            @stop
5 passed, 0 failed; coverage reaches --min-coverage
goals of pump: 29 of 29 reached
goals of valve: 22 of 22 reached
{"smc-goals":1,"application":"stand","machines":[
{"machine":"pump","goals":[]},
{"machine":"valve","goals":[]}],"written":[],"found":[]}
goals of pump: 29 of 29 reached
goals of valve: 22 of 22 reached
goals of pump: 2 of 2 reached
goals of valve: 6 of 6 reached
kept: made/stand-pump-3-on-to-off.ss has been edited
goals of counter: 4 of 5 reached
goals of setter: 0 of 0 reached
goals of slow: 2 of 2 reached
wrote joint/together-counter-4-wait-to-full.ss: counter: Wait -> Full, taken because count > 7.
wrote joint/together-slow-1-count-to-judge.ss: slow: Count -> Judge, taken because T > 1 s.
wrote joint/together-slow-2-judge-to-early.ss: slow: Judge -> Early, taken because n < 20.
not found in counter:
  line 26: `-> Broken` was never taken from Wait: 'never' was not true together with the rest
goals of watch: 0 of 0 reached
goals of work: 1 of 1 reached
wrote guard/guard-work-1-work-to-done.ss: work: Work -> Done, taken because T >= 1 s and fault == 0.
# Generated by smc cover from guard.app (form 1, checksum e7b2e5c5). A changed script is not overwritten.
# work: Work -> Done, taken because T >= 1 s and fault == 0.
#
# The asserts show what the machine does, not what it should do: check them before you rely on them.

[all_states]
every 20 ms:      a = 0
else:             a = 1
every 20 ms:      b = 0
else:             b = 1
every 20 ms:      c = 0
else:             c = 1
from 0 to 1.01 s: @assert state watch.Watch and state work.Work and fault == 0
at 1.01 s:        @assert state watch.Watch and state work.Done and fault == 0
at 1.01 s:        @stop
goals of pump: 29 of 29 reached
goals of valve: 22 of 22 reached
  Left out: fails.ss, because it fails at fails.ss:2.
wrote none/stand-pump-1-off-to-asking.ss: pump: Off -> Asking, taken because start.
wrote none/stand-pump-guard-2-off-false.ss: pump: In Off, 'start' is false.
wrote none/stand-pump-2-asking-to-on.ss: pump: Asking -> On, taken because open.
wrote none/stand-pump-3-on-to-off.ss: pump: On -> Off, taken because not start.
wrote none/stand-valve-2-open-to-closed.ss: valve: Open -> Closed, taken because not ask.
-- stderr --
setter.sm:11:12: warning: machine 'setter' writes 'count', and so does machine 'counter' [W0960 two-writers]
   11 |     start: count = 9
      |            ^~~~~~~~~
counter.sm:14:5: note: machine 'counter' writes it here
1 warning
smc: 1 of 7 goals were not found; --effort=200 searches longer
alone.ss:1:2: error: 'Off' belongs to a machine, and the machines of an application run here [E0790]
    1 | [Off]
      |  ^~~ write pump.Off
alone.ss:2:1: error: 'T' belongs to a machine, and the machines of an application run here [E0790]
    2 | T == 0: start = true
      | ^ write pump.T or valve.T
2 errors
smc: scripts that do not pass: 1 of 1; what they reach is left out ('smc test' shows why)
broken.sm:7:5: error: unknown element 'start' [E0204]
    7 |     start: -> On
      |     ^~~~~ an element of the state vector: list it as bool start
stand.sv:8:6: note: 'start' is declared here
broken.sm:7:15: error: unknown state 'On' [E0501]
    7 |     start: -> On
      |               ^~ add a section [On]
2 errors
smc: cover cannot set the inputs of 'fractions.app' at times, because its ticks are no whole units of G
smc: cover cannot set the inputs of 'late.app' at times, because [start] sets its time
smc: 'stand.app' decides how its machines step and where they start: remove --step
Try 'smc cover --help'.
smc: --must-not is for the transitions of one machine, and 'stand.app' is an application
Try 'smc cover --help'.
smc: 'stand.app' names its state vector itself: remove --sv
Try 'smc cover --help'.
smc: cover accepts one machine at a time
Try 'smc cover --help'.
-- exit --
0 0 0 0 5 0 1 1 1 1 1 2 2 2 2
