# smc fix writes one comparison for each value of a list, and one condition for each time. Lists that can be ranges stay as they are.
args fix app.sm
args fix app.sm app.ss

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only @range 3, 41.5
F64 q @read_only @range [3 41]
bool valve
I32 v
[local]
const F64 lim = 4
[Hold]
.step
    S in (Hold, Vent): v = 1
    v > 1 and S not in [Hold, Vent]: v = 1
    not S in (Hold, Vent): v = 2
    v in (1, 2, 3): -> Vent
    S == Hold, Vent: v = 1
    S == (Hold, Vent): v = 1
    v == 7: -> Vent()
    p + q > lim: valve = S in (Hold)
[Vent]
.entry
-- app.ss --
[options]
delta_t 10 ms
[all_states]
at 1 s, 2 s: p = 3
from 1 s to 2 s, 3 s to 4 s: p = 1
at 5 s: @assert S in (Hold, Vent) "text"
at 9 s: @stop
-- stdout --
app.sm:4:
  - F64 p @read_only @range 3, 41.5
  - F64 q @read_only @range [3 41]
  + F64 p @read_only @range 3 41.5
  + F64 q @read_only @range 3 41
app.sm:9:
  - const F64 lim = 4
  + F64 lim = 4 @read_only
app.sm:12:
  -     S in (Hold, Vent): v = 1
  -     v > 1 and S not in [Hold, Vent]: v = 1
  -     not S in (Hold, Vent): v = 2
  -     v in (1, 2, 3): -> Vent
  -     S == Hold, Vent: v = 1
  -     S == (Hold, Vent): v = 1
  -     v == 7: -> Vent()
  -     p + q > lim: valve = S in (Hold)
  +     S == Hold or S == Vent: v = 1
  +     v > 1 and (S != Hold and S != Vent): v = 1
  +     not (S == Hold or S == Vent): v = 2
  +     v == 1 or v == 2 or v == 3: -> Vent
  +     S == Hold or S == Vent: v = 1
  +     S == Hold or S == Vent: v = 1
  +     v == 7: -> Vent
  +     p + q > lim: valve = S == Hold
app.sm: 11 fixed
app.ss:4:
  - at 1 s, 2 s: p = 3
  - from 1 s to 2 s, 3 s to 4 s: p = 1
  - at 5 s: @assert S in (Hold, Vent) "text"
  + G == 1 s or G == 2 s: p = 3
  + 1 s <= G < 2 s or 3 s <= G < 4 s: p = 1
  + at 5 s: @assert S == Hold or S == Vent "text"
app.ss: 3 fixed
