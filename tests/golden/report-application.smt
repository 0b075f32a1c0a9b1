# smc report of an application: what its machines share, and a chapter for each of them.  Then without scripts, what is refused, an application whose
# machine does not compile, and the commands that are for one machine.
args report stand.app stand.ss stand.rq --format=text | sed -n '1,/^Findings/p'
args report stand.app stand.ss stand.rq --format=text | sed -n '/^valve: In scripts/,/^valve: Source/p'
args report stand.app stand.ss stand.rq --format=text | grep -B1 '^[-=]*$' | grep '^[A-Zpv].*'
args report stand.app stand.ss --all --format=text | sed -n '/^  Section/,/^The application/p'
args report stand.app stand.ss --format=json | grep -o '^ "[a-z-]*"\|^{.*,' | head -n 9
args report stand.app --format=text | sed -n '/^  Section/,/^$/p'
args report stand.app failing.ss --format=text | sed -n '/^  Section/,/^Costs/p'
args report stand.app stand.ss --prove
args report stand.app stand.ss --io=a.io
args report stand.app stand.ss --net=a.net
args report stand.app stand.ss --sv=stand.sv
args report broken.app
args report empty.app
args cover stand.app stand.ss
args diff stand.app stand.app
args graph stand.app

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
-- stand.ss --
[all_states]
true {
    pressure = 40 + noise(1)
    level = 5
}
G == 100 ms: start = true
G == 2 s: start = false

[pump.On]
pump.T == 1 s: @assert motor and valve.S == Open

[pump.Off]
G > 2.2 s: @stop
-- stand.rq --
R1 "no water, no pump"   never held(motor and level < 2, 100 ms)
R2 "the motor waits for the valve"  never pump.On before valve.Open
-- failing.ss --
[all_states]
G == 50 ms: @assert pump.S == On "the pump runs"
G == 100 ms: @stop
-- broken.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    machine pump "broken.sm"
-- broken.sm --
[state_vector]
U64 time @alias G
U32 pumpState @alias S
[Off]
.step
    start: -> Off
-- empty.app --
[options]
state_vector "stand.sv"
time         time 1 ms

[stand]
every 10 ms:
    task plant
-- stdout --
stand
=====
Design review of the application in stand.app

Overview
--------

  Section          Verdict  Details
  Requirements     passed   2 met in all scripts
  Findings         open     9 open
  Scripts          passed   1 of 1 passed
  pump: Coverage   open     41 of 58 places (71 %)
  valve: Coverage  open     25 of 34 places (74 %)

Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins
of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it  How it is known
  9 open findings         W0921, W0930, W0920, W0903, W0901, W0902 (Findings)

Costs of steps and traceability are on the page of one machine: `smc report` with the file of the
machine, its state vector (`--sv`) and its bindings (`--bind`). `smc prove` with the application
decides requirements.

The application has 2 machines, and a tick every 10 ms.

  Machine  File      Runs every  States  Starts in
  pump     pump.sm   10 ms            4  Off
  valve    valve.sm  20 ms            3  Closed

The application
===============

Shared variables
----------------

Every machine that reads or writes an element of the state vector. An element that a machine reads
and none writes comes from outside: from a pin, a message, or a task in C. In a tick, machines run
in the order of the columns, and each sees what those before it have stored.

  Element     Type  Values from  pump       valve      Comment
  time        U64   the clock    time       time       ms since power-on
  pressure    F64   outside      reads                 bar
  level       F64   outside                 reads      m
  start       bool  outside      reads
  pumpState   U32   a machine    its state
  valveState  U32   a machine               its state
  ask         bool  a machine    writes     reads      the pump wants the valve open
  open        bool  a machine    reads      writes     the valve is open
  motor       bool  a machine    writes

Requirements
------------

Each requirement is judged after every step of every script in which it could be violated. `Times`
is the number of these steps. One that was never judged has not been tested, and one that is
undecided has not been met.

  Requirement  Text                           Rule                                     Verdict
  R1           no water, no pump              never held(motor and level < 2, 100 ms)  met
  R2           the motor waits for the valve  never pump.On before valve.Open          met

Where each requirement is implemented and judged
  Requirement  Text                           Place       Implemented in  Judged in  Times  Result
  R1           no water, no pump              stand.rq:1  nowhere         stand.ss     222  met
  R2           the motor waits for the valve  stand.rq:2  nowhere         stand.ss     185  met

Findings
valve: In scripts
-----------------

States visited by the scripts
  State   Times entered  Steps  Scripts
  Closed              2     16        1
  Open                1     95        1
  Abort               0      0  none

Transitions taken by the scripts
  From    To      Times  Remark
  Closed  Open        1
  Open    Abort       0  never taken
  Open    Closed      1

Not covered by the scripts
No script visits `Abort`. No script takes a transition from `Open` to `Abort`.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places       Covered  Of  Impossible
  transitions        2   3           0
  statements         7   9           0
  guards             5   6           0
  conditions         6   8           0
  states             4   5           0
  parameters         1   3           0

  Line  Not covered
    14  parameter `limit` never had its lowest value 0
    14  parameter `limit` never had its highest value 9
    20  `level > limit` was never false while it decided
    26  `level < limit` was never true
    29  state Abort was never entered

stand.ss
  Step     G  State entered       Duration
     1     0  Closed                   140
     8   140  Open                    1900
   103  2040  Closed         until the end

valve: Source
Design review of the application in stand.app
Overview
The application has 2 machines, and a tick every 10 ms.
The application
Shared variables
Requirements
Findings
Scripts
The random numbers have the seed 0.
Machine pump
pump: Outputs in each state
pump: States
Entered from `On`.
Entered from `Off`.
Entered from `Asking`.
Entered from `Asking` and `On`.
pump: Transitions
pump: Inputs, outputs and parameters
pump: Abort matrix
pump: In scripts
pump: Source
Machine valve
valve: Outputs in each state
valve: States
Entered from `Open`.
Entered from `Closed`.
Entered from `Open`.
valve: Transitions
valve: Inputs, outputs and parameters
valve: Abort matrix
valve: In scripts
No script visits `Abort`. No script takes a transition from `Open` to `Abort`.
valve: Source
  Section                             Verdict  Details
  Findings                            open     9 open
  Scripts                             passed   1 of 1 passed
  pump: Coverage                      open     41 of 58 places (71 %)
  valve: Coverage                     open     25 of 34 places (74 %)
  pump: Changes that scripts notice   open     42.5 % of 40
  valve: Changes that scripts notice  open     47.8 % of 23
  Faults of sensors                   open     of input and kind: 3 elsewhere, 2 differs, 4 aborted, 17 without effect
  Parameters                          passed   2 with a known margin

  What speaks against it  How it is known
  9 open findings         W0921, W0930, W0920, W0903, W0901, W0902 (Findings)

Costs of steps and traceability are on the page of one machine: `smc report` with the file of the
machine, its state vector (`--sv`) and its bindings (`--bind`). `smc prove` with the application
decides requirements.

The application has 2 machines, and a tick every 10 ms.
{"smc-report": 1, "application": "stand",
 "overview"
 "shared"
 "findings"
 "scripts"
 "pump-outputs"
 "pump-states"
 "pump-transitions"
 "pump-variables"
  Section   Verdict  Details
  Findings  open     9 open
  Scripts   open     none were run

  Section          Verdict  Details
  Findings         open     9 open
  Scripts          failed   0 of 1 passed
  pump: Coverage   open     6 of 58 places (10 %)
  valve: Coverage  open     5 of 34 places (15 %)

Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins
of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it  How it is known
  script failing.ss       it fails (Scripts)
  9 open findings         W0921, W0930, W0920, W0903, W0901, W0902 (Findings)

Costs of steps and traceability are on the page of one machine: `smc report` with the file of the
-- stderr --
smc: --all: the page of an application has no proofs; 'smc prove stand.app R.rq' decides requirements
smc: failing.ss failed; the report shows why
smc: --prove: the page of an application has no proofs; 'smc prove stand.app R.rq' decides requirements
Try 'smc report --help'.
smc: 'stand.app' names its files itself: remove --io
Try 'smc report --help'.
smc: 'stand.app' names its files itself: remove --net
Try 'smc report --help'.
smc: 'stand.app' names its state vector itself: remove --sv
Try 'smc report --help'.
broken.sm:6:5: error: unknown element 'start' [E0204]
    6 |     start: -> Off
      |     ^~~~~ an element of the state vector: list it as bool start
stand.sv:11:6: note: 'start' is declared here
1 error
empty.app:1:1: error: the application has no machine that a script could run [E0797]
    1 | [options]
      | ^
1 error
smc: cover requires a folder for the scripts, as in 'smc cover stand.app -o cover'
Try 'smc cover --help'.
smc: 'stand.app' is an application, and smc diff is for one machine, with scripts of that machine. Its machines:
  pump: smc diff OLD.sm pump.sm --sv stand.sv
  valve: smc diff OLD.sm valve.sm --sv stand.sv
smc: 'stand.app' is an application, and smc graph is for one machine, with scripts of that machine. Its machines:
  pump: smc graph pump.sm --sv stand.sv
  valve: smc graph valve.sm --sv stand.sv
-- exit --
0 0 0 0 0 0 0 2 2 2 2 1 1 2 2 2
