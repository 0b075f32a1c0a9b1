# smc prove: violations that need infinities, samples of the first steps, or an input for one step only.  Proofs cover them, so searches try them.
args prove a.sm a.rq
args prove a.sm ranges.rq --assume-ranges --effort=1

-- a.sm --
[options]
step 100 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F32  pump   @read_only @range 50 350
F64  line   @read_only @range 0 9
bool go     @read_only
bool stop   @read_only
F32  bleed

[Warm] @safe
.step
    bleed = 0
    go and line > 8 and not stop: -> Open

[Open]
.entry
    bleed = 20
.step
    roll_avg(pump, 5) < 180: -> Soak

[Soak]
.step
    bleed = clamp(bleed + (roll_avg(pump, 5) - 110) / 10, 10, 60)
    T >= 500 ms: -> Ready

[Ready]
.step
    roll_max(pump, 3) <= 80: -> Run

[Run]
-- a.rq --
R1 "at least 10 while soaking"      always S == Soak implies bleed >= 10
R2 "three samples before Run"       always rising(S == Soak) implies prev(held(pump < 180, 500 ms))
-- ranges.rq --
Q1 "at least 10 while soaking"      always S == Soak implies bleed >= 10
-- stdout --
requirements of a, from state Warm, with a step every 100 ms:
  R1  violated            at least 10 while soaking
      after 3 steps
      # Violates R1 (at least 10 while soaking).

      [options]
      delta_t    100 ms
      init_state Warm

      [all_states]
      at 0 {
          go = true
          line = 9
          pump = -1e39
      }
      at 0:      @assert state Warm and bleed == 0
      at 100 ms: @assert state Open and bleed == 20
      at 200 ms: pump = 1e39
      at 200 ms: @assert state Soak and bleed == 0
      at 200 ms: @stop
  R2  violated            three samples before Run
      after 3 steps
      # Violates R2 (three samples before Run).

      [options]
      delta_t    100 ms
      init_state Warm

      [all_states]
      at 0 {
          line = 9
          go = true
      }
      at 0:      @assert state Warm and bleed == 0
      at 100 ms: @assert state Open and bleed == 20
      at 200 ms: @assert state Soak and bleed == 10
      at 200 ms: @stop
requirements of a, from state Warm, with a step every 100 ms:
  Q1  no violation found  at least 10 while soaking
      [..] steps were tried; what is known about the values is too little for a proof
      [..] abstract states and [..] paths were examined
      what can help: --effort=10, which searches and proves longer
-- exit --
1 5
