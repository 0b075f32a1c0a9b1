# smc diff compares what two machines do, part by part, and says what a changed guard means where that is proved.  Scripts show the first step
# that differs.  Exit code 1: the behaviour differs.
args diff old.sm new.sm run.ss other.ss
args diff old.sm new.sm run.ss --format=markdown
args diff old.sm new.sm run.ss other.ss -o d.json; cat d.json
args diff old.sm new.sm -o d.svg; grep -c 'class="g-[a-z]* g-\(added\|removed\|changed\)"' d.svg; grep -o '<text[^>]*>\(was\|[+~−]\)[^<]*' d.svg | sed 's/.*>//'

-- old.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only
bool valve
bool horn
[local]
F64 LIMIT = 800 @read_only
U16 count = 0
F64 wait = 5 @parameter @range 1 20
[define]
high = p > LIMIT
[all_states]
@except Abort
.step
    p > 1000: -> Abort @req R1
[Fill] @swap
.entry
    valve = true
.step
    high and armed: -> Hold
    roll_avg(p, 5) < 10: -> Abort
    count = count + 1
    T > 100: -> Vent
[Hold]
.step
    valve = p < 500
    T > 50: -> Fill
    p < 0: -> Idle
[Vent]
.step
    horn = count > 3
    if p < 100 {
        valve = false
        -> Idle
    }
[Idle] @safe
.exit
    horn = false
[Abort] @abort @safe
.entry
    valve = true
-- new.sm --
# The same machine, changed in every part.
[options]
step 20 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only @command
bool valve
I16 horn
bool lamp
[local]
F64 LIMIT = 825 @read_only
U16 tries = 0
F64 wait = 6 @parameter @range 1 30
[all_states]
@except Abort Idle
.step
    p > 900: -> Abort @req R2
[Fill] @swap
.entry
    valve = true
.step
    p > LIMIT: -> Hold
    roll_avg(p, 6) < 10: -> Abort
    tries = tries + 1
    T >= 100: -> Vent
[Idle]
.exit
    horn = false
[Hold]
.step
    valve = p < 500 and armed
    T > 50: -> Release
    -50 < p < 0: -> Idle
[Release]
.step
    horn = tries > 3
    if p < 100 {
        valve = false
        -> Idle
    }
    lamp = true
[Vent] @safe
[Abort] @abort @safe
.step
    valve = true
-- run.ss --
[all_states]
G == 0: p = 810
G == 0: armed = true
G == 200 ms: p = 200
G == 400 ms: @stop
-- other.ss --
[all_states]
G == 0: lamp = true
G == 0: @assert lamp
G == 0: @stop
-- stdout --
comparison of old.sm with new.sm: behaviour changed: 20 changes, seen in 1 script
behaviour:
  ~ Fill: -> Hold changed
      - high and armed
      + p > LIMIT
  ~ Fill: -> Abort changed
      - roll_avg(p, 5) < 10
      + roll_avg(p, 6) < 10
  ~ Fill: -> Vent changed
      - T > 100
      + T >= 100
      weaker: also true when T == 100
  ~ Hold: valve in .step changed
      - valve = p < 500
      + valve = p < 500 and armed
  ~ Hold: -> Idle changed
      - p < 0
      + -50 < p < 0
      stronger: no longer true when p <= -50
  ~ Hold: -> Release changed
      - T > 50
      + T > 50
      leads to Release instead of Fill
  + Release: state added
      + Release
  + Release: horn in .step added
      + horn = tries > 3
  + Release: valve in .step added
      + valve = false if p < 100
  + Release: -> Idle added
      + p < 100
  + Release: lamp in .step added
      + lamp = true
  - Vent: horn in .step removed
      - horn = count > 3
  - Vent: valve in .step removed
      - valve = false if p < 100
  - Vent: -> Idle removed
      - p < 100
  - Abort: valve in .entry removed
      - valve = true
  + Abort: valve in .step added
      + valve = true
  ~ all states except Idle and Abort: where [all_states] runs changed
      - all states except Abort
      + all states except Idle and Abort
  ~ all states except Idle and Abort: -> Abort changed
      - p > 1000
      + p > 900
      weaker: also true when 900 < p <= 1000
  ~ element horn changed
      - bool horn
      + I16 horn
  ~ parameter wait changed
      - F64 wait = 5 @parameter @range 1 20
      + F64 wait = 6 @parameter @range 1 30
what surrounds the machine sees:
  ~ Hold: number in S changed
      - 2
      + 3
  ~ Vent: number in S changed
      - 3
      + 5
  ~ Idle: number in S changed
      - 4
      + 2
  ~ Abort: number in S changed
      - 5
      + 6
  + element lamp added
      + bool lamp
  ~ step changed
      - 10
      + 20
      how much G advances from step to step; 0: not declared
  ~ layout of the state vector changed
      - 32 bytes, 6 elements
      + 32 bytes, 7 elements
      images of the one do not run with the other
no change of behaviour:
  ~ Idle: marks of the state changed
      - Idle @safe
      + Idle
  ~ Vent: marks of the state changed
      - Vent
      + Vent @safe
  ~ element armed changed
      - bool armed
      + bool armed @command
  ~ local LIMIT changed
      - F64 LIMIT = 800 @read_only
      + F64 LIMIT = 825 @read_only
  = local count renamed
      - U16 count = 0
      + U16 tries = 0
  - definition high removed
      - p > LIMIT
  - @req R1 removed
  + @req R2 added
scripts:
  run.ss: differs after step 2 (G = 20, state Hold, now Fill): valve = false, now true
      passed after 41 steps, now passed after 21 steps
  other.ss: not compared: it has errors for the old machine
costs:
  instructions of the longest step: 19, now 17
  cycles of the longest step, ATmega, image in flash: 9305, now 9808
  cycles of the longest step, ATmega, image in EEPROM: 9961, now 10424
  bytes of the image: 280, now 293
  bytes of memory on the VM: 162, now 170
findings:
  + Idle: .exit of 'Idle' is never executed: no transition leaves the state [dead-code]
swap without stopping: not possible: the layout of the state vector differs
### new.sm: behaviour changed: 20 changes, seen in 1 script

| | where | what | before | now | meaning |
|---|---|---|---|---|---|
| changed | Fill | -\> Hold | `high and armed` | `p > LIMIT` |  |
| changed | Fill | -\> Abort | `roll_avg(p, 5) < 10` | `roll_avg(p, 6) < 10` |  |
| changed | Fill | -\> Vent | `T > 100` | `T >= 100` | weaker: also true when T == 100 |
| changed | Hold | valve in .step | `valve = p < 500` | `valve = p < 500 and armed` |  |
| changed | Hold | -\> Idle | `p < 0` | `-50 < p < 0` | stronger: no longer true when p \<= -50 |
| changed | Hold | -\> Release | `T > 50` | `T > 50` | leads to Release instead of Fill |
| added | Release | state |  | `Release` |  |
| added | Release | horn in .step |  | `horn = tries > 3` |  |
| added | Release | valve in .step |  | `valve = false if p < 100` |  |
| added | Release | -\> Idle |  | `p < 100` |  |
| added | Release | lamp in .step |  | `lamp = true` |  |
| removed | Vent | horn in .step | `horn = count > 3` |  |  |
| removed | Vent | valve in .step | `valve = false if p < 100` |  |  |
| removed | Vent | -\> Idle | `p < 100` |  |  |
| removed | Abort | valve in .entry | `valve = true` |  |  |
| added | Abort | valve in .step |  | `valve = true` |  |
| changed | all states except Idle and Abort | where \[all\_states\] runs | `all states except Abort` | `all states except Idle and Abort` |  |
| changed | all states except Idle and Abort | -\> Abort | `p > 1000` | `p > 900` | weaker: also true when 900 \< p \<= 1000 |
| changed |  | element horn | `bool horn` | `I16 horn` |  |
| changed |  | parameter wait | `F64 wait = 5 @parameter @range 1 20` | `F64 wait = 6 @parameter @range 1 30` |  |

- run.ss: differs after step 2 (G = 20, state Hold, now Fill): valve = false, now true;  passed after 41 steps, now passed after 21 steps

<details><summary>What surrounds the machine sees (7)</summary>

| | where | what | before | now | meaning |
|---|---|---|---|---|---|
| changed | Hold | number in S | `2` | `3` |  |
| changed | Vent | number in S | `3` | `5` |  |
| changed | Idle | number in S | `4` | `2` |  |
| changed | Abort | number in S | `5` | `6` |  |
| added |  | element lamp |  | `bool lamp` |  |
| changed |  | step | `10` | `20` | how much G advances from step to step; 0: not declared |
| changed |  | layout of the state vector | `32 bytes, 6 elements` | `32 bytes, 7 elements` | images of the one do not run with the other |

</details>

<details><summary>No change of behaviour (8)</summary>

| | where | what | before | now | meaning |
|---|---|---|---|---|---|
| changed | Idle | marks of the state | `Idle @safe` | `Idle` |  |
| changed | Vent | marks of the state | `Vent` | `Vent @safe` |  |
| changed |  | element armed | `bool armed` | `bool armed @command` |  |
| changed |  | local LIMIT | `F64 LIMIT = 800 @read_only` | `F64 LIMIT = 825 @read_only` |  |
| renamed |  | local count | `U16 count = 0` | `U16 tries = 0` |  |
| removed |  | definition high | `p > LIMIT` |  |  |
| removed |  | @req R1 |  |  |  |
| added |  | @req R2 |  |  |  |

</details>

<details><summary>Costs and findings</summary>

| cost | before | now |
|---|---:|---:|
| instructions of the longest step | 19 | 17 |
| cycles of the longest step, ATmega, image in flash | 9305 | 9808 |
| cycles of the longest step, ATmega, image in EEPROM | 9961 | 10424 |
| bytes of the image | 280 | 293 |
| bytes of memory on the VM | 162 | 170 |

- appeared: .exit of 'Idle' is never executed: no transition leaves the state

</details>

Swap without stopping: not possible: the layout of the state vector differs.
{"smc-diff":1,"old":"old.sm","new":"new.sm","same":false,"same_layout":false,"same_image":false,"swap":"not possible: the layout of the state vector differs",
"changes":[
{"part":"transition","how":"changed","weight":"behaviour","where":"Fill","what":"-> Hold","old":"high and armed","new":"p > LIMIT","meaning":null,"old_line":24,"new_line":24},
{"part":"transition","how":"changed","weight":"behaviour","where":"Fill","what":"-> Abort","old":"roll_avg(p, 5) < 10","new":"roll_avg(p, 6) < 10","meaning":null,"old_line":25,"new_line":25},
{"part":"transition","how":"changed","weight":"behaviour","where":"Fill","what":"-> Vent","old":"T > 100","new":"T >= 100","meaning":"weaker: also true when T == 100","old_line":27,"new_line":27},
{"part":"mark","how":"changed","weight":"note","where":"Idle","what":"marks of the state","old":"Idle @safe","new":"Idle","meaning":null},
{"part":"statement","how":"changed","weight":"behaviour","where":"Hold","what":"valve in .step","old":"valve = p < 500","new":"valve = p < 500 and armed","meaning":null,"old_line":30,"new_line":33},
{"part":"transition","how":"changed","weight":"behaviour","where":"Hold","what":"-> Idle","old":"p < 0","new":"-50 < p < 0","meaning":"stronger: no longer true when p <= -50","old_line":32,"new_line":35},
{"part":"transition","how":"changed","weight":"behaviour","where":"Hold","what":"-> Release","old":"T > 50","new":"T > 50","meaning":"leads to Release instead of Fill","old_line":31,"new_line":34},
{"part":"state","how":"added","weight":"behaviour","where":"Release","what":"state","old":null,"new":"Release","meaning":null},
{"part":"statement","how":"added","weight":"behaviour","where":"Release","what":"horn in .step","old":null,"new":"horn = tries > 3","meaning":null,"new_line":38},
{"part":"statement","how":"added","weight":"behaviour","where":"Release","what":"valve in .step","old":null,"new":"valve = false if p < 100","meaning":null,"new_line":40},
{"part":"transition","how":"added","weight":"behaviour","where":"Release","what":"-> Idle","old":null,"new":"p < 100","meaning":null,"new_line":41},
{"part":"statement","how":"added","weight":"behaviour","where":"Release","what":"lamp in .step","old":null,"new":"lamp = true","meaning":null,"new_line":43},
{"part":"statement","how":"removed","weight":"behaviour","where":"Vent","what":"horn in .step","old":"horn = count > 3","new":null,"meaning":null,"old_line":35},
{"part":"statement","how":"removed","weight":"behaviour","where":"Vent","what":"valve in .step","old":"valve = false if p < 100","new":null,"meaning":null,"old_line":37},
{"part":"transition","how":"removed","weight":"behaviour","where":"Vent","what":"-> Idle","old":"p < 100","new":null,"meaning":null,"old_line":38},
{"part":"mark","how":"changed","weight":"note","where":"Vent","what":"marks of the state","old":"Vent","new":"Vent @safe","meaning":null},
{"part":"statement","how":"removed","weight":"behaviour","where":"Abort","what":"valve in .entry","old":"valve = true","new":null,"meaning":null,"old_line":45},
{"part":"statement","how":"added","weight":"behaviour","where":"Abort","what":"valve in .step","old":null,"new":"valve = true","meaning":null,"new_line":47},
{"part":"state","how":"changed","weight":"behaviour","where":"all states except Idle and Abort","what":"where [all_states] runs","old":"all states except Abort","new":"all states except Idle and Abort","meaning":null},
{"part":"transition","how":"changed","weight":"behaviour","where":"all states except Idle and Abort","what":"-> Abort","old":"p > 1000","new":"p > 900","meaning":"weaker: also true when 900 < p <= 1000","old_line":19,"new_line":19},
{"part":"state","how":"changed","weight":"interface","where":"Hold","what":"number in S","old":"2","new":"3","meaning":null},
{"part":"state","how":"changed","weight":"interface","where":"Vent","what":"number in S","old":"3","new":"5","meaning":null},
{"part":"state","how":"changed","weight":"interface","where":"Idle","what":"number in S","old":"4","new":"2","meaning":null},
{"part":"state","how":"changed","weight":"interface","where":"Abort","what":"number in S","old":"5","new":"6","meaning":null},
{"part":"variable","how":"changed","weight":"note","where":"","what":"element armed","old":"bool armed","new":"bool armed @command","meaning":null},
{"part":"variable","how":"changed","weight":"behaviour","where":"","what":"element horn","old":"bool horn","new":"I16 horn","meaning":null},
{"part":"variable","how":"changed","weight":"note","where":"","what":"local LIMIT","old":"F64 LIMIT = 800 @read_only","new":"F64 LIMIT = 825 @read_only","meaning":null},
{"part":"variable","how":"renamed","weight":"note","where":"","what":"local count","old":"U16 count = 0","new":"U16 tries = 0","meaning":null},
{"part":"variable","how":"changed","weight":"behaviour","where":"","what":"parameter wait","old":"F64 wait = 5 @parameter @range 1 20","new":"F64 wait = 6 @parameter @range 1 30","meaning":null},
{"part":"variable","how":"added","weight":"interface","where":"","what":"element lamp","old":null,"new":"bool lamp","meaning":null},
{"part":"variable","how":"removed","weight":"note","where":"","what":"definition high","old":"p > LIMIT","new":null,"meaning":null},
{"part":"option","how":"changed","weight":"interface","where":"","what":"step","old":"10","new":"20","meaning":"how much G advances from step to step; 0: not declared"},
{"part":"mark","how":"removed","weight":"note","where":"","what":"@req R1","old":null,"new":null,"meaning":null},
{"part":"mark","how":"added","weight":"note","where":"","what":"@req R2","old":null,"new":null,"meaning":null},
{"part":"layout","how":"changed","weight":"interface","where":"","what":"layout of the state vector","old":"32 bytes, 6 elements","new":"32 bytes, 7 elements","meaning":"images of the one do not run with the other"}],
"scripts":[
{"script":"run.ss","problem":null,"same":false,"steps":2,"old_result":"passed after 41 steps","new_result":"passed after 21 steps","step":2,"G":20,"old_state":"Hold","new_state":"Fill","values":[{"name":"valve","old":"false","new":"true"}]},
{"script":"other.ss","problem":"it has errors for the old machine","same":null,"steps":0,"old_result":null,"new_result":null}],
"costs":[
{"name":"instructions of the longest step","old":19,"new":17},
{"name":"cycles of the longest step, ATmega, image in flash","old":9305,"new":9808},
{"name":"cycles of the longest step, ATmega, image in EEPROM","old":9961,"new":10424},
{"name":"bytes of the image","old":280,"new":293},
{"name":"bytes of memory on the VM","old":162,"new":170}],
"findings":[
{"appeared":true,"code":"W0514","where":"Idle","message":".exit of 'Idle' is never executed: no transition leaves the state"}]}
13
~ p &gt; LIMIT
was high and armed
~ roll_avg(p, 6) &lt; 10
was roll_avg(p, 5) &lt; 10
~ T &gt;= 100
was T &gt; 100
+ T &gt; 50
~ -50 &lt; p &lt; 0
was p &lt; 0
− T &gt; 50
+ p &lt; 100
− p &lt; 100
~ p &gt; 900
was p &gt; 1000
~ Hold
+ Release
~ Vent
~ Abort
-- exit --
1 1 0 0
