# smc prove with scripts: each is replayed exactly and judged, and searches start from it.  No search finds these five numbers.
args prove a.sm a.rq a.ss writes.ss other.ss -w --effort=1
args prove a.sm a.rq a.ss -w --effort=1 --format=json | grep -o '"scripts".*"requirements\|"violated_by.*[0-9]'
args prove a.sm a.rq -w --effort=1
args prove a.sm a.rq fails.ss -w --effort=1
args test a.sm a.rq a.ss -w --traceability=t.csv --prove >log 2>&1; tr -d '\015' <t.csv | awk -F, '$1 == "requirement" {print $2, $NF}'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  key    @read_only
bool start  @read_only
bool open

[local]
F64 a = 0
F64 b = 0
U32 limit = 77

[Idle]
.step
    start: -> Wait

[Wait]
.step
    T > 4 s: -> Read

[Read]
.step
    a = a * 31 + key * key
    a = a - 65521 * floor(a / 65521)
    b = b * 57 + key * (key + 3)
    b = b - 65521 * floor(b / 65521)
    T >= 40 ms and a == 40961 + limit - 77 and b == 41309: -> Open
    T >= 40 ms: -> Idle
.exit
    a = 0
    b = 0

[Open]
.step
    open = true
-- a.rq --
R1 "never open"   never open
R2 "waits"        never Read before Wait
-- a.ss --
[options]
init_state Idle

[all_states]
at 0: start = true
at 4.03 s: key = 46535
at 4.04 s: key = 29009
at 4.05 s: key = 77
at 4.06 s: key = 17146
at 4.07 s: key = 31576
at 4.1 s: @stop
-- writes.ss --
[options]
init_state Idle

[all_states]
at 0:      start = true
at 100 ms: limit = 1
at 200 ms: @stop
-- other.ss --
[options]
init_state Wait

[all_states]
at 200 ms: @stop
-- fails.ss --
[options]
init_state Idle

[all_states]
at 200 ms: @assert open
at 200 ms: @stop
-- stdout --
requirements of a, from state Idle, with a step every 10 ms:
  script a.ss: 411 steps
  script writes.ss: the first 10 of 21 steps, because then it sets 'limit'
  script other.ss: not used, because it begins in state Wait
  R1  violated            never open
      the script a.ss violates it in its step 409
      after 409 steps
      # Violates R1 (never open).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:                  start = true
      at 0:                  @assert state Idle and not open
      from 10 ms to 4.03 s:  @assert state Wait and not open
      at 4.03 s:             key = 46535
      from 4.03 s to 4.08 s: @assert state Read and not open
      at 4.04 s:             key = 29009
      at 4.05 s:             key = 77
      at 4.06 s:             key = 17146
      at 4.07 s:             key = 31576
      at 4.08 s:             @assert state Open and open
      at 4.08 s:             @stop
  R2  proved              waits
      in Idle: a is 0, b is 0
      in Wait: a is 0, b is 0, T is at most 4010
      in Read: T is at most 40
      in Open: a is 0, b is 0
"scripts":[{"name":"a.ss","steps":411,"used":411}],"requirements
"violated_by":"a.ss","violated_by_step":409
requirements of a, from state Idle, with a step every 10 ms:
  R1  no violation found  never open
      992432 steps were tried; what is known about the values is too little for a proof
      no run that was tried came to Open
      8 abstract states and 301615 paths were examined
      what can help: a script that comes to these states, named in the command; @range on 'key', with --assume-ranges; --effort=10, which searches and proves longer
  R2  proved              waits
      in Idle: a is 0, b is 0
      in Wait: a is 0, b is 0, T is at most 4010
      in Read: T is at most 40
      in Open: a is 0, b is 0
requirements of a, from state Idle, with a step every 10 ms:
  script fails.ss: 21 steps
  R1  no violation found  never open
      992433 steps were tried; what is known about the values is too little for a proof
      no run that was tried came to Open
      8 abstract states and 301615 paths were examined
      what can help: a script that comes to these states, named in the command; @range on 'key', with --assume-ranges; --effort=10, which searches and proves longer
  R2  proved              waits
      in Idle: a is 0, b is 0
      in Wait: a is 0, b is 0, T is at most 4010
      in Read: T is at most 40
      in Open: a is 0, b is 0
R1 violated
R2 proved
-- stderr --
smc: fails.ss does not pass: its 21 steps up to there are a beginning of the search ('smc test' shows why it fails)
-- exit --
1 0 5 5 0
