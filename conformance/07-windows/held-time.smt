spec 7.30, 7.32  held(c, t): true at every sample since one at least t before this one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool a
bool b
[all_states]
.step
    a = held(p > 5, 25 ms)        #! W0425
    b = held(p > 5, 1 ms)        #! W0425
[Run]
.step
    T > 3: -> Next
[Next]

-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 6
G == 0: @assert not a and not b
G == 10: @assert not a and b
G == 20: @assert not a
G == 30: @assert a
G == 40: p = 0
G == 40: @assert not a and not b
G == 50: p = 6
G == 70: @assert not a
G == 80: @assert a and b
G == 80: @stop
