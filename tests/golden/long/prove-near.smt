# smc prove with scripts: violations that differ from the run of a script in one or two inputs.  No search finds these five numbers, so what is after them
# is only reached by the script.
args prove a.sm a.rq a.ss -w --effort=1
args prove a.sm a.rq a.ss -w --effort=1 --format=json | grep -o '"violated_near".*]'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time     @alias G
U32  state    @alias S
F64  key      @read_only
bool start    @read_only
F32  levelA   @read_only @range 0 100
F32  levelB   @read_only @range 0 100
F32  chamber  @read_only @range 0 60

[local]
F64 a = 0
F64 b = 0
F32 first = 0
bool fault = false

[define]
level = average(levelA, levelB)

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
    T >= 40 ms and a == 40961 and b == 41309: -> LeakCheck
    T >= 40 ms: -> Idle
.exit
    a = 0
    b = 0

[LeakCheck]
.entry first = level
.step
    held(levelA - levelB > 3, 200 ms): fault = true
    T >= 500 ms {
        first - level > 0.5: -> Abort
        -> Fill
    }

[Fill]
.entry fault = false
.step T >= 100 ms: -> Armed

[Armed]
.step
    fault: -> Abort
    a = a * 31 + key * key
    a = a - 65521 * floor(a / 65521)
    T >= 300 ms and a == 52954.359375 and abs(levelA - levelB) < 3: -> Ignition

[Ignition]
.entry a = 0
.step T >= 1 s: -> Idle

[Abort]
.entry a = 0
.step T >= 1 s: -> Idle
-- a.rq --
L1 "loss on the limit"        always prev(S == LeakCheck and T >= 500 ms and first - average(levelA, levelB) >= 0.5) implies S == Abort
I1 "pressure in the chamber"  never prev(S == Armed and chamber >= 2) and S == Ignition
I2 "two inputs"               never prev(S == Armed and chamber > 2 and levelA == levelB + 1) and S == Ignition
F1 "no fire after a fault"    never (S == Ignition) after (S == LeakCheck and held(levelA - levelB > 3, 200 ms)) without (S == Idle)
-- a.ss --
[options]
init_state Idle

[all_states]
at 0 {
    start = true
    levelA = 50
    levelB = 50
}
at 4.03 s: key = 46535
at 4.04 s: key = 29009
at 4.05 s: key = 77
at 4.06 s: key = 17146
at 4.07 s: key = 31576

[LeakCheck]
T == 100 ms: levelA = 49.9

[Armed]
T == 340 ms: key = 4711.375
T == 350 ms: key = 99.5

[Ignition]
T == 100 ms: @stop
-- stdout --
requirements of a, from state Idle, with a step every 10 ms:
  script a.ss: 517 steps
  L1  violated            loss on the limit
      the script a.ss violates it in its step 460 if levelA is 49 in its step 459
      after 460 steps
      # Violates L1 (loss on the limit).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0 {
          start = true
          levelA = 50
      }
      at 0:                  @assert state Idle
      from 10 ms to 4.03 s:  @assert state Wait
      at 4.03 s:             key = 46535
      from 4.03 s to 4.08 s: @assert state Read
      at 4.04 s:             key = 29009
      at 4.05 s:             key = 77
      at 4.06 s:             key = 17146
      at 4.07 s:             key = 31576
      from 4.08 s to 4.59 s: @assert state LeakCheck
      at 4.58 s:             levelA = 49
      at 4.59 s:             @assert state Fill
      at 4.59 s:             @stop
  I1  violated            pressure in the chamber
      the script a.ss violates it in its step 507 if chamber is 2 in its step 506
      after 507 steps
      # Violates I1 (pressure in the chamber).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:                  start = true
      at 0:                  @assert state Idle
      from 10 ms to 4.03 s:  @assert state Wait
      at 4.03 s:             key = 46535
      from 4.03 s to 4.08 s: @assert state Read
      at 4.04 s:             key = 29009
      at 4.05 s:             key = 77
      at 4.06 s:             key = 17146
      at 4.07 s:             key = 31576
      from 4.08 s to 4.59 s: @assert state LeakCheck
      from 4.59 s to 4.7 s:  @assert state Fill
      from 4.7 s to 5.06 s:  @assert state Armed
      at 5.04 s:             key = 4711.375
      at 5.05 s {
          chamber = 2
          key = 99.5
      }
      at 5.06 s:             @assert state Ignition
      at 5.06 s:             @stop
  I2  violated            two inputs
      the script a.ss violates it in its step 507 if levelA is 51 and chamber is 2.0000002 in its step 506
      after 507 steps
      # Violates I2 (two inputs).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:                  start = true
      at 0:                  @assert state Idle
      from 10 ms to 4.03 s:  @assert state Wait
      at 4.03 s:             key = 46535
      from 4.03 s to 4.08 s: @assert state Read
      at 4.04 s:             key = 29009
      at 4.05 s:             key = 77
      at 4.06 s:             key = 17146
      at 4.07 s:             key = 31576
      from 4.08 s to 4.59 s: @assert state LeakCheck
      from 4.59 s to 4.7 s:  @assert state Fill
      from 4.7 s to 5.06 s:  @assert state Armed
      at 5.04 s:             key = 4711.375
      at 5.05 s {
          levelA = 1
          chamber = 2.0000002
          key = 99.5
      }
      at 5.06 s:             @assert state Ignition
      at 5.06 s:             @stop
  F1  violated            no fire after a fault
      the script a.ss violates it in its step 507 if levelB is 46.999996 from its step 388 to 409
      after 507 steps
      # Violates F1 (no fire after a fault).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0 {
          start = true
          levelA = 50
      }
      at 0:                  @assert state Idle
      from 10 ms to 4.03 s:  @assert state Wait
      at 4.03 s:             key = 46535
      from 4.03 s to 4.08 s: @assert state Read
      at 4.04 s:             key = 29009
      at 4.05 s:             key = 77
      at 4.06 s:             key = 17146
      at 4.07 s:             key = 31576
      from 4.08 s to 4.59 s: @assert state LeakCheck
      at 4.09 s:             levelB = 50
      from 4.59 s to 4.7 s:  @assert state Fill
      from 4.7 s to 5.06 s:  @assert state Armed
      at 5.04 s:             key = 4711.375
      at 5.05 s:             key = 99.5
      at 5.06 s:             @assert state Ignition
      at 5.06 s:             @stop
"violated_near":"a.ss","violated_near_step":460,"other_inputs":[{"name":"levelA","value":49,"from_step":459,"to_step":459}]
"violated_near":"a.ss","violated_near_step":507,"other_inputs":[{"name":"chamber","value":2,"from_step":506,"to_step":506}]
"violated_near":"a.ss","violated_near_step":507,"other_inputs":[{"name":"levelA","value":51,"from_step":506,"to_step":506},{"name":"chamber","value":2.000000238418579,"from_step":506,"to_step":506}]
"violated_near":"a.ss","violated_near_step":507,"other_inputs":[{"name":"levelB","value":46.999996185302734,"from_step":388,"to_step":409}]
-- exit --
1 0
