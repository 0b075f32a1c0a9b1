spec 8.35  Of several that are undecided when the script stops, the one that began first is reported.
expect fail

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
bool on
[Run] @safe
.step
    on = x > 5
-- app.ss --
[options]
delta_t 10
[all_states]
G == 20: @expect on within 1 s
G == 10: @expect on within 2 s      #! E0756 G = 10
G == 30: @stop
