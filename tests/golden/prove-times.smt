# smc prove on the sum of the times in several states: bounds that widening has moved too far come back in a second exploration.
args prove a.sm a.rq --effort=1

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F32  p      @read_only
bool go     @read_only
bool drogue
bool main

[local]
F32 highest = 0

[Pad]
.step
    T > 100 ms and go: -> Ascent

[Ascent]
.step
    highest = max(highest, p)
    20 < p < highest - 4: -> Drogue
    T > 12 s: -> Drogue

[Drogue]
.entry
    drogue = true
.step
    T >= 1 s: drogue = false
    T > 2 s and 20 < p < 100: -> Main
    T > 9 s: -> Main

[Main]
.entry
    drogue = false
    main = true
.step
    T >= 1 s: -> Descent
.exit
    main = false

[Descent]
-- a.rq --
R1 "the main opens in time"    always S == Ascent leads to S == Main within 21.04 s
R2 "the main opens too late"   always S == Ascent leads to S == Main within 21.03 s
-- stdout --
requirements of a, from state Pad, with a step every 10 ms:
  R1  proved              the main opens in time
      in Pad: highest is 0
      in Ascent: highest is at least 0, T is at most 12010
      in Drogue: highest is at least 0, T is at most 9010
      in Main: highest is at least 0, T is at most 1000
      in Descent: highest is at least 0
  R2  violated            the main opens too late
      after 2116 steps
      # Violates R2 (the main opens too late).

      [options]
      delta_t    10 ms
      init_state Pad

      [all_states]
      at 0:                    go = true
      from 0 to 120 ms:        @assert state Pad and not drogue and not main
      from 120 ms to 12.14 s:  @assert state Ascent and not drogue and not main
      from 12.14 s to 13.14 s: @assert state Drogue and drogue and not main
      after 13.14 s:           @assert state Drogue and not drogue and not main
      at 21.15 s:              @stop
-- exit --
1
