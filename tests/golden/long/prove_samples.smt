# smc prove: what is true of single samples and what the machine reads of all of them, as the smallest, are known together.
args prove a.sm a.rq --effort=1 | grep '^  N'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
F64  q      @read_only
bool vent
bool alarm

[local]
F64 limit = 35

[Press]
.step
    roll_min(p, 50 ms) > limit: -> Vent
    roll_max(p - q, 2) > 5: -> Alarm

[Vent]
.entry
    vent = true
.step
    roll_max(p, 50 ms) <= 10: -> Press
.exit
    vent = false

[Alarm]
.entry
    alarm = true
-- a.rq --
N1 "50 ms of pressure"         always held(p > 35, 50 ms) and S == Press leads to S != Press within 10 ms
N2 "40 ms are too few"         always held(p > 35, 40 ms) and S == Press leads to S != Press within 10 ms
N3 "another limit"             always held(p > 34, 50 ms) and S == Press leads to S != Press within 10 ms
N4 "closed after 50 ms"        never held(p < 10, 70 ms) and S == Vent
N5 "the largest of two"        always roll_max(p, 50 ms) <= 10 implies p <= 10 and prev(p) <= 10
-- stdout --
  N1  proved              50 ms of pressure
  N2  violated            40 ms are too few
  N3  violated            another limit
  N4  proved              closed after 50 ms
  N5  proved              the largest of two
