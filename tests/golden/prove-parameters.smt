# What is proved is true of every setting of a parameter; if only the value in the source fulfils a requirement, the verdict says so.  With
# --any-parameters such a requirement is violated by a script that sets the parameters.
args prove a.sm a.rq
args prove a.sm a.rq --any-parameters
args prove a.sm a.rq --any-parameters --requirements=R3 | sed -n '/^      #/,$s/^      //p' >r3.ss && "$SMC" test a.sm a.rq r3.ss >out.txt 2>&1; grep -o 'requirement R[0-9] violated' out.txt
args prove b.sm b.rq --any-parameters

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 out
F64 other
bool ready
[local]
F64 limit = 40 @parameter @range 30 50
U8 count = 3 @parameter @range 2 4
bool on = true @parameter
[Run]
.step
    out = limit * 2
    other = count
    ready = on
-- a.rq --
R1 "every setting"                  always out >= 60 and out <= 100
R2 "the default alone, from below"  always out >= 70
R3 "the default alone, from above"  always out <= 90
R4 "every count"                    always 2 <= other <= 4
R5 "the default of the count"       always other > 2
R6 "the default of a bool"          always ready
R7 "not even the default"           never  out > 79 and out < 81
-- b.sm --
# Neither parameter alone does it.
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool fire
[local]
F64 low = 20  @parameter @range 0 40
F64 high = 80 @parameter @range 60 100
I16 delay = -5 @parameter @range -9 -1
[Idle]
.step
    p > 7 and high - low > 99: -> Fire
[Fire]
.entry
    fire = true
-- b.rq --
B1 "no fire"       never fire
B2 "it is ready"   always high - low >= 20
B3 "the delay"     always delay <= -2
-- stdout --
requirements of a, from state Run, with a step every 10 ms:
  R1  proved              every setting
      in Run: out is from 60 to 100
  R2  proved              the default alone, from below
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: out is 80
  R3  proved              the default alone, from above
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: out is 80
  R4  proved              every count
      in Run: other is from 2 to 4
  R5  proved              the default of the count
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: other is 3
  R6  proved              the default of a bool
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: ready is true
  R7  violated            not even the default
      after 1 steps
      # Violates R7 (not even the default).

      [options]
      delta_t    10 ms
      init_state Run

      [all_states]
      at 0: @assert state Run and out == 80 and other == 3 and ready
      at 0: @stop
requirements of a, from state Run, with a step every 10 ms:
  R1  proved              every setting
      in Run: out is from 60 to 100
  R2  violated            the default alone, from below
      after 1 steps
      # Violates R2 (the default alone, from below).

      [options]
      delta_t    10 ms
      init_state Run
      set        limit 30

      [all_states]
      at 0: @assert state Run and out == 60 and other == 3 and ready
      at 0: @stop
  R3  violated            the default alone, from above
      after 1 steps
      # Violates R3 (the default alone, from above).

      [options]
      delta_t    10 ms
      init_state Run
      set        limit 50

      [all_states]
      at 0: @assert state Run and out == 100 and other == 3 and ready
      at 0: @stop
  R4  proved              every count
      in Run: other is from 2 to 4
  R5  violated            the default of the count
      after 1 steps
      # Violates R5 (the default of the count).

      [options]
      delta_t    10 ms
      init_state Run
      set        count 2

      [all_states]
      at 0: @assert state Run and out == 80 and other == 2 and ready
      at 0: @stop
  R6  violated            the default of a bool
      after 1 steps
      # Violates R6 (the default of a bool).

      [options]
      delta_t    10 ms
      init_state Run
      set        on false

      [all_states]
      at 0: @assert state Run and out == 80 and other == 3 and not ready
      at 0: @stop
  R7  violated            not even the default
      after 1 steps
      # Violates R7 (not even the default).

      [options]
      delta_t    10 ms
      init_state Run

      [all_states]
      at 0: @assert state Run and out == 80 and other == 3 and ready
      at 0: @stop
requirement R3 violated
requirements of b, from state Idle, with a step every 10 ms:
  B1  violated            no fire
      after 2 steps
      # Violates B1 (no fire).

      [options]
      delta_t    10 ms
      init_state Idle
      set        low 0
      set        high 100

      [all_states]
      at 0:     p = 7.1
      at 0:     @assert state Idle and not fire
      at 10 ms: @assert state Fire and fire
      at 10 ms: @stop
  B2  proved              it is ready
  B3  violated            the delay
      after 1 steps
      # Violates B3 (the delay).

      [options]
      delta_t    10 ms
      init_state Idle
      set        delay -1

      [all_states]
      at 0: @assert state Idle and not fire
      at 0: @stop
-- exit --
1 1 0 1
