# smc prove of an application: what one machine stores is decided by a proof about it alone, if it steps in every tick.  What it reads, and what two
# machines store, is not: `level` can change between a step of the valve and the next tick, as between.ss shows.
args prove stand.app stand.rq
args prove stand.app stand.rq --requirements=R3,R8
args prove stand.app stand.rq --requirements=R4
args prove stand.app stand.rq --requirements=R3,R1 --format=json
args prove mode.app stand.rq --requirements=R1,R3
args prove start.app stand.rq --requirements=R1,R3
args prove two.app two.rq
args prove writers.app writers.rq
args test writers.app writers.ss writers.rq | grep violated
args prove fractions.app fractions.rq
args prove stand.app against.rq
args prove stand.app unknown.rq
args test stand.app between.ss between.rq | grep violated
args prove stand.app between.rq
args prove stand.app stand.rq between.ss
args prove stand.app stand.rq --step=10
args prove stand.app stand.rq --init-state=Off
args prove stand.app stand.rq --sv=stand.sv
args prove stand.app

-- stand.sv --
# The state vector of a stand: a valve that a pump asks to open.

[Time]
U64  time               # ms since power-on

[Sensors]
F64  pressure @range 0 100      # bar
F64  level    @range 0 10       # m

[Commands]
bool start    @command

[Machines]
U32  pumpState
U32  valveState
bool ask                # the pump wants the valve open
bool open               # the valve is open
bool motor
U8   mode
-- pump.sm --
# A pump that runs while the valve is open.

[options]
step 10 ms

[state_vector]
U64  time      @alias G
U32  pumpState @alias S
F64  pressure  @read_only @range 0 100
bool start     @read_only
bool open      @read_only
bool ask
bool motor

[local]
F64 limit = 60 @parameter @range 10 90

[Off] @safe
.entry
    ask = false
.step
    start: -> Asking

[Asking]
.entry
    ask = true
.step
    open: -> On
    T > 500 ms: -> Abort

[On]
.entry
    motor = true
.step
    pressure > limit: -> Abort
    not open: -> Abort
    not start: -> Off
.exit
    motor = false

[Abort] @abort
.entry
    ask = false
    motor = false
-- valve.sm --
# A valve that opens when it is asked and the tank has water.

[options]
step 20 ms

[state_vector]
U64  time       @alias G
U32  valveState @alias S
F64  level      @read_only @range 0 10
bool ask        @read_only
bool open

[local]
F64 limit = 2 @parameter @range 0 9

[Closed] @safe
.entry
    open = false
.step
    ask and level > limit: -> Open

[Open]
.entry
    open = true
.step
    level < limit: -> Abort
    not ask: -> Closed

[Abort] @abort
.entry
    open = false
-- stand.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine pump "pump.sm"
every 20 ms:
    machine valve "valve.sm"
-- mode.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine pump "pump.sm" @mode mode
every 20 ms:
    machine valve "valve.sm"
-- start.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[start]
motor = true

[stand]
every 10 ms:
    machine pump "pump.sm"
every 20 ms:
    machine valve "valve.sm"
-- two.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine first "pump.sm" { pumpState = pumpState }
    machine second "pump.sm" { pumpState = valveState }
-- fractions.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine pump "pump.sm"
every 2500 us:
    task plant
-- stand.rq --
R1 "no water, no pump"              never held(motor and level < 2, 100 ms)
R2 "the motor waits for the valve"  never pump.On before valve.Open
R3 "the motor runs only in On"      always motor implies pump.S == On
R4 "the motor stops in time"        always motor leads to not motor within 1 s
R5 "asking ends"                    always pump.S == Asking leads to pump.S != Asking within 520 ms
R6 "open is a state"                always open implies valve.S == Open
R7 "time"                           never G > 100 and G < 50
R8 "asking for a while"             always held(pump.S == Asking, 100 ms) implies pump.T >= 100 ms
-- keep.sm --
[state_vector]
U64  time      @alias G
U32  pumpState @alias S
bool ask

[Good] @safe
.step
    ask: -> Bad
    ask = false

[Bad]
-- set.sm --
[state_vector]
U64  time       @alias G
U32  valveState @alias S
bool start      @read_only
bool ask

[Set] @safe
.step
    ask = start
-- writers.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine keep "keep.sm"
    machine set  "set.sm"
-- writers.rq --
R1 "another machine writes what keep assigns"  always keep.S == Good
R2 "and keep writes what set assigns"          always set.S == Set
-- writers.ss --
[all_states]
at 0: start = true
at 50 ms: @stop
-- two.rq --
R1 "both"  always motor implies first.S == On
-- fractions.rq --
R1 "the motor runs only in On"      always motor implies pump.S == On
-- against.rq --
R1 "never"   never motor
R2 "always"  always motor
-- unknown.rq --
R1 "drained"  never drained
-- between.rq --
R1 "closed without water"  never open and level < 1
-- between.ss --
[all_states]
true {
    pressure = 40
    start = true
    level = 5
}
G >= 210: level = 0
at 1 s: @stop
-- stdout --
requirements of pump, from state Off, with a step every 10 ms:
  R3  proved              the motor runs only in On
      assuming that only this machine writes the elements that it assigns
      assuming that in the first step G and the elements that the machine assigns are 0
      in Off: motor is false
      in Asking: motor is false, T is at most 510
      in Abort: motor is false
  R4  violated alone      the motor stops in time
      after 103 steps
      # Violates R4 (the motor stops in time).

      [options]
      delta_t    10 ms
      init_state Off

      [all_states]
      at 0 {
          start = true
          open = true
      }
      at 0:        @assert state Off and not ask and not motor
      at 10 ms:    @assert state Asking and ask and not motor
      after 20 ms: @assert state On and ask and motor
      at 1.02 s:   @stop
      this run is of pump alone: in the application, its inputs may never have these values
  R5  proved              asking ends
      in Asking: T is at most 510
  R8  proved              asking for a while
      in Asking: T is at most 510
requirements of stand that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         no water, no pump
      because no machine writes 'level'
  R2  not decided         the motor waits for the valve
      because it is about two machines, pump and valve
  R6  not decided         open is a state
      because valve does not step in every tick
  R7  not decided         time
      because it reads nothing that a machine stores
requirements of pump, from state Off, with a step every 10 ms:
  R3  proved              the motor runs only in On
      assuming that only this machine writes the elements that it assigns
      assuming that in the first step G and the elements that the machine assigns are 0
      in Off: motor is false
      in Asking: motor is false, T is at most 510
      in Abort: motor is false
  R8  proved              asking for a while
      in Asking: T is at most 510
requirements of pump, from state Off, with a step every 10 ms:
  R4  violated alone      the motor stops in time
      after 103 steps
      # Violates R4 (the motor stops in time).

      [options]
      delta_t    10 ms
      init_state Off

      [all_states]
      at 0 {
          start = true
          open = true
      }
      at 0:        @assert state Off and not ask and not motor
      at 10 ms:    @assert state Asking and ask and not motor
      after 20 ms: @assert state On and ask and motor
      at 1.02 s:   @stop
      this run is of pump alone: in the application, its inputs may never have these values
{"smc-proofs":1,"application":"stand","machines":[
{"smc-proofs":1,"machine":"pump","state":"Off","delta_t":10,"scripts":[],"requirements":[
{"id":"R3","text":"the motor runs only in On","verdict":"proved","premise_seen":true,"steps":222,"abstract_states":9,"paths":5085,"assumptions":["own-outputs","zero-start"],"invariants":[{"state":"Off","reached":true,"values":[{"name":"motor","least":0,"most":0}]},{"state":"Asking","reached":true,"values":[{"name":"motor","least":0,"most":0},{"name":"T","least":0,"most":510}]},{"state":"On","reached":true,"values":[]},{"state":"Abort","reached":true,"values":[{"name":"motor","least":0,"most":0}]}]}
]}
],"undecided":[
{"id":"R1","because":"no machine writes 'level'"}]}
requirements of mode that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         no water, no pump
      because no machine writes 'level'
  R3  not decided         the motor runs only in On
      because pump steps only while 'mode' enables it
requirements of start that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         no water, no pump
      because no machine writes 'level'
  R3  not decided         the motor runs only in On
      because [start] sets 'motor'
requirements of two that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         both
      because several machines write 'motor'
requirements of writers that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         another machine writes what keep assigns
      because set writes 'ask', too, which keep assigns
  R2  not decided         and keep writes what set assigns
      because keep writes 'ask', too, which set assigns
  R1  violated  another machine writes what keep assigns
requirements of fractions that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         the motor runs only in On
      because the ticks of the application are no whole units of G
  R1  violated  closed without water
requirements of stand that no machine decides alone; 'smc test' judges them in scripts:
  R1  not decided         closed without water
      because no machine writes 'level'
-- stderr --
pump.sm:20:5: warning: machine 'second' writes 'ask', and so does machine 'first' [W0960 two-writers]
   20 |     ask = false
      |     ^~~~~~~~~~~
pump.sm:20:5: note: machine 'first' writes it here
pump.sm:33:5: warning: machine 'second' writes 'motor', and so does machine 'first' [W0960 two-writers]
   33 |     motor = true
      |     ^~~~~~~~~~~~
pump.sm:33:5: note: machine 'first' writes it here
2 warnings
set.sm:9:5: warning: machine 'set' writes 'ask', and so does machine 'keep' [W0960 two-writers]
    9 |     ask = start
      |     ^~~~~~~~~~~
keep.sm:9:5: note: machine 'keep' writes it here
1 warning
set.sm:9:5: warning: machine 'set' writes 'ask', and so does machine 'keep' [W0960 two-writers]
    9 |     ask = start
      |     ^~~~~~~~~~~
keep.sm:9:5: note: machine 'keep' writes it here
1 warning
writers.rq:1:55: error: requirement R1 violated in step 3 (G = 20, state keep.Bad, set.Set): another machine writes what keep assigns [E1310]
    1 | R1 "another machine writes what keep assigns"  always keep.S == Good
      |                                                       ^~~~~~~~~~~~~~ keep.S = Bad, number 2
writers.ss:1:1: note: this script ran
note: the last steps, and the values after each:
      step   G  state                       keep.S
         1   0  keep.Good, set.Set  Good, number 1
         2  10  keep.Good, set.Set  Good, number 1
         3  20  keep.Bad, set.Set    Bad, number 2
keep.sm:8:10: note: transition in step 2 (G = 10): keep.Good -> Bad
note: keep: no sequence of transitions leads from Bad to Good
note: 3 later steps violated it, too, the last of them step 6 (G = 50)
1 error
against.rq:2:1: error: requirement R2 contradicts R1: no step can meet both [E1312]
    2 | R2 "always"  always motor
      | ^~
against.rq:1:1: note: the first one is here
1 error
unknown.rq:1:21: error: unknown element 'drained' [E0204]
    1 | R1 "drained"  never drained
      |                     ^~~~~~~
1 error
between.rq:1:34: error: requirement R1 violated in step 22 (G = 210, state pump.On, valve.Open): closed without water [E1310]
    1 | R1 "closed without water"  never open and level < 1
      |                                  ^~~~~~~~~~~~~~~~~~ open = true, level = 0
between.ss:1:1: note: this script ran
note: the last steps, and the values after each:
      step    G  state                open  level
        18  170  pump.On, valve.Open  true      5
        19  180  pump.On, valve.Open  true      5
        20  190  pump.On, valve.Open  true      5
        21  200  pump.On, valve.Open  true      5
        22  210  pump.On, valve.Open  true      0
pump.sm:22:12: note: transition in step 1 (G = 0): pump.Off -> Asking
valve.sm:20:28: note: transition in step 3 (G = 20): valve.Closed -> Open
pump.sm:28:11: note: transition in step 6 (G = 50): pump.Asking -> On
valve.sm:24:5: note: valve: step 5 (G = 40): `open = true` was executed
note: 2 later steps violated it, too, the last of them step 24 (G = 230)
1 error
smc: scripts of an application do not help a proof, which is about one of its machines: remove 'between.ss'
Try 'smc prove --help'.
smc: 'stand.app' decides how its machines step and where they start: remove --step
Try 'smc prove --help'.
smc: 'stand.app' decides how its machines step and where they start: remove --init-state
Try 'smc prove --help'.
smc: 'stand.app' names its state vector itself: remove --sv
Try 'smc prove --help'.
smc: requirements are required, as in 'smc prove M.sm R.rq'
Try 'smc prove --help'.
-- exit --
5 0 5 5 5 5 5 5 0 5 1 1 0 5 2 2 2 2 2
