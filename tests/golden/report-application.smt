# smc report of an application: what its machines share, and a chapter for each of them.  Then without scripts, what is refused, an application whose
# machine does not compile, and the commands that are for one machine.
args report stand.app stand.ss stand.rq --format=text | sed -n '1,/^pump: Outputs/p; /^What must/,/^pump: Abort/p; /^valve: Findings/,/^  No/p'
args report stand.app stand.ss stand.rq --format=text | sed -n '/^valve: In scripts/,/^What it costs/p; /^valve: Costs/,/^valve: Source/p'
args report stand.app stand.ss stand.rq --format=text | grep -B1 '^[-=]*$' | grep '^[A-Zpv].*'
args report stand.app stand.ss --all --format=text | sed -n '/^  Section/,/^What it does/p'
args report twice.app two.ss --format=text | sed -n '/^second: Findings/,/^second: Abort/p'
args report twice.app two.ss --format=text | grep -c 'The machine runs in steps'
args report stand.app stand.ss --format=json | grep -o '^ "[a-z-]*"\|^{.*,' | head -n 9
args report stand.app --format=text | sed -n '/^  Section/,/^$/p'
args report stand.app failing.ss --format=text | sed -n '/^  Section/,/^Trace/p'
args report stand.app stand.ss own.rq --prove --format=text | sed -n '/^  Section/,/^The app/p;/^Proofs$/,/^pump: Find/p'
args report stand.app against.rq --prove
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

[pump.Abort]
G == 5 s {
    @assert false "it stops"
    @stop
}
-- stand.rq --
R1 "no water, no pump"   never held(motor and level < 2, 100 ms)
R2 "the motor waits for the valve"  never pump.On before valve.Open
-- own.rq --
R1 "no water, no pump"          never held(motor and level < 2, 100 ms)
R2 "the motor runs only in On"  always motor implies pump.S == On
R3 "the motor stops in time"    always motor leads to not motor within 1 s
R4 "asking ends"                always pump.S == Asking leads to pump.S != Asking within 520 ms
R5 "never water at the valve"   never valve.S == Open
-- against.rq --
R1 "never"   never motor
R2 "always"  always motor
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
-- two.sv --
[Time]
U64  time
[Sensors]
F64  level    @range 0 10
bool ask      @command
[Machines]
U32  firstState
U32  secondState
bool firstOpen
bool secondOpen
-- twice.app --
[options]
state_vector "two.sv"
time         time 1 ms

[stand]
every 20 ms:
    machine first "valve.sm" { valveState = firstState  open = firstOpen }
    machine second "valve.sm" { valveState = secondState  open = secondOpen }
-- two.ss --
[all_states]
true: level = 5
G > 1 s: @stop
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

  Section              Verdict  Details
  Requirements         passed   2 met in all scripts
  pump: Findings       open     3 open
  valve: Findings      open     6 open
  Scripts              passed   1 of 1 passed
  pump: Coverage       open     41 of 58 places (71 %)
  valve: Coverage      open     25 of 34 places (74 %)
  pump: Longest step            14 instructions, in On
  valve: Longest step           9 instructions, in Closed

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

Not examined: proofs of the requirements (`--prove`), changes that no script notices (`--mutate`),
faults of sensors (`--faults`), margins of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it  How it is known
  pump: 3 open findings   W0921, W0930, W0920 (pump: Findings)
  valve: 6 open findings  W0903, W0901, W0902, W0921, W0930, W0920 (valve: Findings)

Traceability is on the page of one machine: `smc report` with the file of the machine, its state
vector (`--sv`) and its bindings (`--bind`).

The application has 2 machines, and a tick every 10 ms.

  Machine  File      Runs every  States  Starts in
  pump     pump.sm   10 ms            4  Off
  valve    valve.sm  20 ms            3  Closed

What it does
============

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

pump: Outputs in each state
What must never happen, and how we know
=======================================

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

pump: Findings
--------------

Findings of all groups of warnings. `smc explain` with a name or code prints what a finding means
and what to do. Time advances in each step of a machine by the period with which the application
runs it.

  No.  Name             Group     Position      Finding                                                                                  Code
    1  missing-timeout  -Wflight  pump.sm:31:2  'On' switches 'motor' on and has no transition that time alone makes                     W0921
    2  not-tried        -Wflight  pump.sm:31:2  trial runs have not tried everything: not every failure of 'pressure' was tried in 'On'  W0930
    3  missing-way-out  -Wflight  pump.sm:41:2  the machine can never leave 'Abort'                                                      W0920

'On' switches 'motor' on and has no transition that time alone makes [W0921 missing-timeout]
     31 | [On]

    - 'motor' is switched on here

trial runs have not tried everything: not every failure of 'pressure' was tried in 'On' [W0930 not-tried]
     31 | [On]

    - a script that leads through the state, run with 'smc faults', tries failures of this sensor there

the machine can never leave 'Abort' [W0920 missing-way-out]
     41 | [Abort] @abort
        | if the machine can stay here for good, write [Abort] @safe

pump: Abort matrix
valve: Findings
---------------

Findings of all groups of warnings. `smc explain` with a name or code prints what a finding means
and what to do. Time advances in each step of a machine by the period with which the application
runs it.

  No.  Name                 Group     Position        Finding                                                                                                  Code
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

What it costs
valve: Costs
------------

  State   First step  Later steps  Most expensive lines of the longest step  Cycles on AVR
  Closed           9            6  line 20: 6, line 18: 3                             2199
  Open             9            6  line 24: 3, line 26: 3, line 27: 2                 2199
  Abort            3            0  line 31: 3                                         1039

The longest step, in `Closed`
  Block   Line  Statement                       Instructions
  .entry    18  open = false                               3
  .step     20  ask and level > limit: -> Open             6

On an Arduino Uno
  Part                                     Value
  Longest step, image in EEPROM            2199 cycles, 0.14 ms, in Closed
  Longest step, image in flash             1729 cycles, 0.11 ms, in Closed
  Stack of a step, largest measured        319 bytes
  RAM of state vector, locals and windows  56 bytes of at most 960
  Image                                    177 bytes of at most 960

Memory
  Part                           Bytes
  Windows of rolling statistics      0
  Locals and temporary values        8
  State of the VM                   96
  RAM in total                     104
  State vector                      48
  Image, in flash or RAM           177
  of which code                     43

Design review of the application in stand.app
Overview
Failed: something is shown to be wrong.
vector (`--sv`) and its bindings (`--bind`).
The application has 2 machines, and a tick every 10 ms.
What it does
Shared variables
pump: Outputs in each state
pump: States
Entered from `On`.
Entered from `Off`.
Entered from `Asking`.
Entered from `Asking` and `On`.
pump: Transitions
pump: Inputs, outputs and parameters
valve: Outputs in each state
valve: States
Entered from `Open`.
Entered from `Closed`.
Entered from `Open`.
valve: Transitions
valve: Inputs, outputs and parameters
What must never happen, and how we know
Requirements
pump: Findings
pump: Abort matrix
valve: Findings
valve: Abort matrix
What was tested, and what was not
Scripts
The random numbers have the seed 0.
pump: In scripts
valve: In scripts
No script visits `Abort`. No script takes a transition from `Open` to `Abort`.
What it costs
pump: Costs
C depends on the compiler and is not estimated.
valve: Costs
  Section                             Verdict  Details
  pump: Findings                      open     3 open
  valve: Findings                     open     6 open
  Scripts                             passed   1 of 1 passed
  pump: Coverage                      open     41 of 58 places (71 %)
  valve: Coverage                     open     25 of 34 places (74 %)
  pump: Changes that scripts notice   open     42.5 % of 40
  valve: Changes that scripts notice  open     47.8 % of 23
  Faults of sensors                   open     of input and kind: 3 elsewhere, 2 differs, 4 aborted, 17 without effect
  Parameters                          passed   2 with a known margin
  pump: Longest step                           14 instructions, in On
  valve: Longest step                          9 instructions, in Closed

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

  What speaks against it  How it is known
  pump: 3 open findings   W0921, W0930, W0920 (pump: Findings)
  valve: 6 open findings  W0903, W0901, W0902, W0921, W0930, W0920 (valve: Findings)

Traceability is on the page of one machine: `smc report` with the file of the machine, its state
vector (`--sv`) and its bindings (`--bind`).

The application has 2 machines, and a tick every 10 ms.

  Machine  File      Runs every  States  Starts in
  pump     pump.sm   10 ms            4  Off
  valve    valve.sm  20 ms            3  Closed

What it does
second: Findings
----------------

`valve.sm` is also the file of `first`, and the findings are the same.

second: Abort matrix
1
{"smc-report": 1, "application": "stand",
 "overview"
 "shared"
 "pump-outputs"
 "pump-states"
 "pump-transitions"
 "pump-variables"
 "valve-outputs"
 "valve-states"
  Section              Verdict  Details
  pump: Findings       open     3 open
  valve: Findings      open     6 open
  Scripts              open     none were run
  pump: Longest step            14 instructions, in On
  valve: Longest step           9 instructions, in Closed

  Section              Verdict  Details
  pump: Findings       open     3 open
  valve: Findings      open     6 open
  Scripts              failed   0 of 1 passed
  pump: Coverage       open     6 of 58 places (10 %)
  valve: Coverage      open     5 of 34 places (15 %)
  pump: Longest step            14 instructions, in On
  valve: Longest step           9 instructions, in Closed

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins
of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it  How it is known
  script failing.ss       it fails (Scripts)
  pump: 3 open findings   W0921, W0930, W0920 (pump: Findings)
  valve: 6 open findings  W0903, W0901, W0902, W0921, W0930, W0920 (valve: Findings)

Traceability is on the page of one machine: `smc report` with the file of the machine, its state
  Section                  Verdict  Details
  Requirements in scripts  failed   2 violated, 3 met in all scripts
  Proofs                   open     1 violated alone, 2 not decided, 2 proved
  pump: Findings           open     3 open
  valve: Findings          open     6 open
  Scripts                  failed   0 of 1 passed
  pump: Coverage           open     41 of 58 places (71 %)
  valve: Coverage          open     25 of 34 places (74 %)
  pump: Longest step                14 instructions, in On
  valve: Longest step               9 instructions, in Closed

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins
of parameters (`--sweep`). `smc report --all` adds them.

  What speaks against it        How it is known
  R3: the motor stops in time   stand.ss violates it in step 117
  R5: never water at the valve  stand.ss violates it in step 15
  pump: 3 open findings         W0921, W0930, W0920 (pump: Findings)
  valve: 6 open findings        W0903, W0901, W0902, W0921, W0930, W0920 (valve: Findings)

Traceability is on the page of one machine: `smc report` with the file of the machine, its state
vector (`--sv`) and its bindings (`--bind`).

The application has 2 machines, and a tick every 10 ms.
Proofs
------

`smc prove` decides the requirements that one machine of the application decides alone. A proof
holds whatever the other machines and tasks write, in the ticks of the application. A run that
violates a requirement is one of this machine alone: the others may never write what it needs. What
no machine decides alone is only as good as its tests.

R1: no water, no pump [not decided]
  because no machine writes 'level'

R2: the motor runs only in On [proved]
  of the machine pump
  assuming that only this machine writes the elements that it assigns
  assuming that in the first step G and the elements that the machine assigns are 0
  in Off: motor is false
  in Asking: motor is false, T is at most 510
  in Abort: motor is false

R3: the motor stops in time [violated alone]
  of the machine pump
  after 103 steps
  # Violates R3 (the motor stops in time).

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

R4: asking ends [proved]
  of the machine pump
  in Asking: T is at most 510

R5: never water at the valve [not decided]
  because valve does not step in every tick

pump: Findings
-- stderr --
smc: failing.ss failed; the report shows why
smc: stand.ss failed; the report shows why
against.rq:2:1: error: requirement R2 contradicts R1: no step can meet both [E1312]
    2 | R2 "always"  always motor
      | ^~
against.rq:1:1: note: the first one is here
1 error
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
0 0 0 0 0 0 0 0 0 0 1 2 2 2 1 1 2 2 2
