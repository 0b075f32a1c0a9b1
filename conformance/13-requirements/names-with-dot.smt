spec 13.23  In requirements of one machine, names stand alone.
expect error

-- app.sm --
[state_vector]
U64 G
U32 S
bool on

[A] @safe
.step
    on = T > 3
-- app.rq --
R1 "T"      never app.T == 3          #! E0791
R2 "state"  never app.A before (on)   #! E0791
-- app.ss --
[options]
delta_t 10
[all_states]
G == 20: @assert on
G == 20: @stop
