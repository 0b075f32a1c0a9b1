spec 13.9, 13.3  `state` can be the name of a constant, also where it is the length of a window in steps.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool on

[local]
U8 state = 3 @read_only

[A] @safe
.step
    on = roll_avg(p, state steps) > 2
-- app.rq --
R1 "x"  always roll_avg(p, state steps) > 2 implies on
-- app.ss --
[all_states]
G == 0: p = 0
G == 20: p = 9
G == 50: @assert on
G == 50: @stop
