# No change of behaviour: other names of states and locals, another order of states, a definition written out, a constant in place of its name,
# a comparison the other way round, another layout.  What surrounds the machine sees the numbers of the states.
args diff old.sm same.sm run.ss -o same.txt && cat same.txt
args diff old.sm old.sm --format=markdown -MD -MF old.d -MT all && cat old.d
args diff tank.sm tank2.sm --sv one.sv && echo same

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
-- same.sm --
# Another layout.
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
U16 total = 0
F64 wait = 5 @parameter @range 1 20
[all_states]
@except Abort
.step
    p > 1000: -> Abort @req R1
[Fill] @swap
.entry
    valve = true
.step
    p > 800 and armed: -> Pause
    roll_avg(p, 5) < 10: -> Abort
    total = total + 1
    T > 100: -> Vent
[Pause]
.step
    valve = p < 500
    50 < T: -> Fill
    p < 0: -> Idle
[Idle] @safe
.exit
    horn = false
[Vent]
.step
    horn = total > 3
    if p < 100 {
        valve = false
        -> Idle
    }
[Abort] @abort @safe
.entry
    valve = true
-- run.ss --
[all_states]
G == 0: p = 810
G == 0: armed = true
G == 200 ms: p = 200
G == 400 ms: @stop
-- one.sv --
[bus]
U64 G
U32 S
F64 p
F64 q
-- tank.sm --
[state_vector]
U64 G
U32 S
F64 p
[A] @safe
.step
    p > 1: -> A
-- tank2.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
[A] @safe
.step
    if (p) > 1.0 { -> A }
-- stdout --
comparison of old.sm with same.sm: no change of behaviour
what surrounds the machine sees:
  ~ Vent: number in S changed
      - 3
      + 4
  ~ Idle: number in S changed
      - 4
      + 3
no change of behaviour:
  = Pause: state Hold renamed
      - Hold
      + Pause
      certain: its statements and the transitions to it are equal
  - local LIMIT removed
      - F64 LIMIT = 800 @read_only
  = local count renamed
      - U16 count = 0
      + U16 total = 0
  - definition high removed
      - p > LIMIT
scripts:
  run.ss: equal in 41 steps, passed after 41 steps
swap without stopping: possible in Fill, Idle, Abort
### old.sm: no change of behaviour

<details><summary>Costs and findings</summary>

| cost | before | now |
|---|---:|---:|
| instructions of the longest step | 19 | 19 |
| cycles of the longest step, ATmega, image in flash | 9305 | 9305 |
| cycles of the longest step, ATmega, image in EEPROM | 9961 | 9961 |
| bytes of the image | 280 | 280 |
| bytes of memory on the VM | 162 | 162 |

</details>

Swap without stopping: possible in Fill, Idle, Abort.
all: old.sm old.sm
comparison of tank.sm with tank2.sm: no change of behaviour
what surrounds the machine sees:
  + element q added
      + F64 q
findings:
  + element 'q' is never used [unused-element]
image: the same logic
swap without stopping: possible in A
same
