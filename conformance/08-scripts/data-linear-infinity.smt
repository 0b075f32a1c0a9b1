spec 8.63, 8.64  Between two infinities the formula has no number: NaN is stored, as by any assignment, and not the value of the step before.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool seen
[Hold] @safe
.step
    seen = p > 0
-- flight.csv --
t,p
0,1
20,inf
40,inf
60,7
-- app.ss --
[options]
delta_t 10
[data]
file "flight.csv"
time "t" ms
linear
p = "p"
[all_states]
at 10:  @assert p > 1e308 and seen
at 20:  @assert p == 0 and not seen
at 30:  @assert p == 0
at 50:  @assert p == 0
at 60:  @assert p == 7 and seen
at 60:  @stop
