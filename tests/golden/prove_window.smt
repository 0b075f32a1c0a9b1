# smc prove: a requirement that depends on a window that it does not read.  The cheaper attempts let that window have any value: never fewer than
# it has.
args prove a.sm a.rq

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
F64  q      @read_only
bool a      @read_only
bool b      @read_only
bool open

[Idle] @safe
.step
    rising(b): -> Newest
    prev(p) > 5: -> Oldest
    held(a, 30 ms): -> Held
    roll_range(q, 2) > 5: -> Moved

[Newest]
.entry
    open = true

[Oldest]
.entry
    open = true

[Held]
.entry
    open = true

[Moved]
.entry
    open = true
-- a.rq --
N1 "the last sample opens"        never S == Newest
N6 "the sample before it opens"   never S == Oldest
N2 "three samples open"           never S == Held
N3 "a change opens"               never S == Moved
N4 "nothing but these opens"      always open implies S != Idle
N5 "not in the first step"        always S != Idle implies G >= 10
-- stdout --
requirements of a, from state Idle, with a step every 10 ms:
  N1  violated            the last sample opens
      after 3 steps
      # Violates N1 (the last sample opens).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      from 0 to 20 ms: @assert state Idle and not open
      at 10 ms:        b = true
      at 20 ms:        @assert state Newest and open
      at 20 ms:        @stop
  N6  violated            the sample before it opens
      after 2 steps
      # Violates N6 (the sample before it opens).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:     p = 5.1
      at 0:     @assert state Idle and not open
      at 10 ms: @assert state Oldest and open
      at 10 ms: @stop
  N2  violated            three samples open
      after 5 steps
      # Violates N2 (three samples open).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      at 0:            a = true
      from 0 to 40 ms: @assert state Idle and not open
      at 40 ms:        @assert state Held and open
      at 40 ms:        @stop
  N3  violated            a change opens
      after 3 steps
      # Violates N3 (a change opens).

      [options]
      delta_t    10 ms
      init_state Idle

      [all_states]
      from 0 to 20 ms: @assert state Idle and not open
      at 10 ms:        q = 5.1
      at 20 ms:        @assert state Moved and open
      at 20 ms:        @stop
  N4  proved              nothing but these opens
      assuming that only this machine writes the elements that it assigns
      assuming that in the first step G and the elements that the machine assigns are 0
      in Idle: open is false
      in Newest: open is true
      in Oldest: open is true
      in Held: open is true
      in Moved: open is true
  N5  proved              not in the first step
-- exit --
1
