spec 7.32, 7.33  Steps without a gap continue the run; a sample that is false ends it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool a
[options]
step 10 ms
[Run]
.step
    a = held(p < 5, 20 ms)

-- app.ss --
[all_states]
G == 10: @assert not a
G == 20: @assert a
G == 30: p = 6
G == 30: @assert not a
G == 40: p = 1
G == 60: @assert a
G == 60: @stop
