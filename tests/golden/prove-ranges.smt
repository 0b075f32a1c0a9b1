# smc prove --assume-ranges: a script sets each input with a range to a value in it, from the first step on.
args prove a.sm a.rq --assume-ranges

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only @range 10 500
F64  q      @read_only @range 5 9
bool valve

[Idle] @safe
.step
    p > 100: -> Open

[Open] @safe
.entry
    valve = true
-- a.rq --
R1 "shut at a low level"     never valve and q < 6
R2 "shut at no level"        never valve and q < 4
-- stdout --
requirements of a, from state Idle, with a step every 10 ms:
  R1  violated            shut at a low level
      after 2 steps
      # Violates R1 (shut at a low level).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0 {
          q = 5
          p = 500
      }
      at 0:     @assert state Idle and not valve
      at 10 ms: @assert state Open and valve
      at 10 ms: @stop
  R2  proved              shut at no level
      assuming that elements with @range have values in it
-- exit --
1
