# What a run cannot know (the other machines, the state vector, the step, the scripts) may need an @allow: it is not called unused.
args check b.sm --sv r.sv
args check a.sm b.sm --sv r.sv
args check b.sm a.sm --sv r.sv
args check c.sm
args check c.sm --sv r.sv
args check -Wflight d.sm
args check -Wflight --step=100 d.sm
args check e.sm
args check e.sm e.ss
args test e.sm e.ss --step=105
args fix b.sm c.sm d.sm e.sm
args check -Wflight --step=10 d.sm
args check e.sm f.ss
args report e.sm e.ss --format=text -o r.txt
args fix d.sm --step=10 && cat d.sm

-- r.sv --
[R]
U64 G
U32 S
F64 p
U32 S2
bool valve
F64 lim
-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve

[Run]
.step
    valve = p > 700
-- b.sm --
[state_vector]
U64 G
U32 S2 @alias S
F64 p @read_only
bool valve

[Run]
.step
    @allow(two-writers, "reviewed 12 May")
    p > 900: valve = true
-- c.sm --
[state_vector]
U64 G
U32 S2 @alias S
F64 p @read_only
bool valve
[local]
F64 lim = 700 @read_only @allow(local-like-element, "ours")
[Run]
.step
    p > lim: valve = true
-- d.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
bool valve
[Wait] @safe
.step
    @allow(window-not-full, "p is warm by then")
    T > 1000 and roll_avg(p, 50) < 20 and q < 3: -> Open
[Open] @safe
.entry
    valve = true
-- e.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
[local]
F64 limit = 700 @read_only @allow(script-writes-constant, "tests try a lower limit")
[Run] @safe
.step
    valve = p > limit
    @allow(exact-moment, "checked with the step of the stand")
    T == 105: valve = false
-- e.ss --
[options]
delta_t 105
[all_states]
G == 0: limit = 100
G == 105: p = 200
G == 210: @assert valve
G == 315: @stop
-- f.ss --
[options]
delta_t 105
[all_states]
G == 105: p = 200
G == 210: @assert not valve
G == 315: @stop
-- stdout --
state script ran for 4 steps
1 assert passed
final state vector:
  G = 315
  S = 1
  T = 315
  limit = 100.000000
  p = 200.000000
  valve = true
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
bool valve
[Wait] @safe
.step
    @allow(window-not-full, "p is warm by then")
    T > 1000 and roll_avg(p, 50) < 20 and q < 3: -> Open
[Open] @safe
.entry
    valve = true
-- stderr --
d.sm:9:5: warning: unused '@allow(window-not-full)': no warning needs it here [W0210 unused-allow]
    9 |     @allow(window-not-full, "p is warm by then")
      |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ leave it out
1 warning
