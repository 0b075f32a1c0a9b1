# smc prove: each verdict, with what is true in each state, and with the script that shows a violation.
args prove a.sm a.rq
args prove a.sm two.rq --assume-ranges
args prove a.sm two.rq --init-state=Hold --format=json -o r.json; cat r.json
args prove a.sm a.rq --requirements=R6,R4 --effort=1
args prove a.sm a.rq --requirements=R5 --format=json | grep -c verdict
args prove a.sm one.rq --init-state=Hold --effort=1

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only @range 0 500
bool arm    @read_only
bool valve
U8   count

[Idle] @safe
.entry
    valve = false
.step
    arm: -> Fill

[Fill]
.entry
    valve = true
    count = 0
.step
    held(p > 100, 50 ms) or T >= 2 s: -> Hold
    p > 900: -> Never
.exit
    valve = false

[Hold]
.step
    count = count + 1
    count >= 3: -> Idle

[Never] @safe
-- a.rq --
R1 "closed outside of filling"   never S != Fill and valve
R2 "filling ends"                always S == Fill leads to S != Fill within 2010 ms
R3 "no second fill"              never Fill after Idle without Hold
R4 "no hold before filling"      never Hold before Fill
R5 "the count is small"          never count > 3
R7 "filling ends sooner"         always S == Fill leads to S != Fill within 2 s
R8 "three samples are equal"     never arm and roll_min(arm, 3) == 0
R6 "armed before filling"        always rising(valve) implies arm
-- two.rq --
Q1 "nothing after Never"         always S == Never implies valve
-- one.rq --
Q2 "the sum fits"                never p + p * 2 - 3 * p > 1000
-- stdout --
requirements of a, from state Idle, with a step every 10 ms:
  R1  proved              closed outside of filling
      assuming that only this machine writes the elements that it assigns
      in Idle: valve is false
      in Fill: count is 0, T is at most 2000
      in Hold: valve is false, count is from 1 to 3
      in Never: valve is false, count is 0
  R2  proved              filling ends
      in Fill: T is at most 2000
      in Hold: count is at least 1
  R3  violated            no second fill
      after 2 steps
      # Violates R3 (no second fill).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:     arm = true
      at 0:     @assert state Idle and not valve and count == 0
      at 10 ms: @assert state Fill and valve and count == 0
      at 10 ms: @stop
  R4  proved              no hold before filling
      in Fill: T is at most 2000
      in Hold: count is at least 1
  R5  proved              the count is small
      assuming that only this machine writes the elements that it assigns
      assuming that in the first step G and the elements that the machine assigns are 0
      in Idle: count is at most 3
      in Fill: count is 0, T is at most 2000
      in Hold: count is from 1 to 3
      in Never: count is 0
  R7  violated            filling ends sooner
      after 202 steps
      # Violates R7 (filling ends sooner).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:                 arm = true
      at 0:                 @assert state Idle and not valve and count == 0
      from 10 ms to 2.01 s: @assert state Fill and valve and count == 0
      at 2.01 s:            @assert state Fill and not valve and count == 0
      at 2.01 s:            @stop
  R8  violated            three samples are equal
      after 2 steps
      # Violates R8 (three samples are equal).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      true:     @assert state Idle and not valve and count == 0
      at 10 ms: arm = true
      at 10 ms: @stop
  R6  violated            armed before filling
      after 2 steps
      # Violates R6 (armed before filling).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:     arm = true
      at 0:     @assert state Idle and not valve and count == 0
      at 10 ms: arm = false
      at 10 ms: @assert state Fill and valve and count == 0
      at 10 ms: @stop
requirements of a, from state Idle, with a step every 10 ms:
  Q1  vacuous             nothing after Never
      no run comes to its premise, so it requires nothing
      assuming that elements with @range have values in it
      in Fill: T is at most 2000
      in Hold: count is at least 1
      in Never: it is never reached
{"smc-proofs":1,"machine":"a","state":"Hold","delta_t":10,"scripts":[],"requirements":[
{"id":"Q1","text":"nothing after Never","verdict":"violated","premise_seen":true,"steps":[..],"abstract_states":[..],"paths":[..],"assumptions":[],"violated_after":6,"changes":2,"script":"# Violates Q1 (nothing after Never).\u000a\u000a[options]\u000adelta_t    10 ms\u000ainit_state Hold\u000a\u000a[all_states]\u000aat 0:     @assert state Hold and not valve and count == 1\u000aat 10 ms: arm = true\u000aat 10 ms: @assert state Hold and not valve and count == 2\u000aat 20 ms: @assert state Hold and not valve and count == 3\u000aat 30 ms: @assert state Idle and not valve and count == 3\u000aat 40 ms: p = 901\u000aat 40 ms: @assert state Fill and not valve and count == 0\u000aat 50 ms: @assert state Never and not valve and count == 0\u000aat 50 ms: @stop\u000a"}
]}
requirements of a, from state Idle, with a step every 10 ms:
  R4  proved              no hold before filling
      in Fill: T is at most 2000
      in Hold: count is at least 1
  R6  violated            armed before filling
      after 2 steps
      # Violates R6 (armed before filling).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:     arm = true
      at 0:     @assert state Idle and not valve and count == 0
      at 10 ms: arm = false
      at 10 ms: @assert state Fill and valve and count == 0
      at 10 ms: @stop
1
requirements of a, from state Hold, with a step every 10 ms:
  Q2  no violation found  the sum fits
      [..] steps were tried; a proof needs too many abstract states
      [..] abstract states and [..] paths were examined
      too many values for a proof have: T, the samples of held(p > 100, 50 ms)
      a proof can become possible by: a shorter timer than 2000 ms in Fill; fewer samples in held(p > 100, 50 ms)
      what can help: --assume-ranges, if there are no values beyond the @range of 'p'; --effort=10, which searches and proves longer
-- exit --
1 0 0 1 0 5
