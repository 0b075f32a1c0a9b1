spec 7.30, 7.31  held(c, n steps): true in the last n samples.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool a
bool b
bool c
[define]
n = 3
[all_states]
.step
    a = held(p > 5, 3 steps)        #! W0425
    b = held(p > 5 and p < 50, n steps)        #! W0425
    c = held(p, 1 steps)        #! W0425
[Run]
.step
    T > 3: -> Next
[Next]

-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 6
G == 0: @assert not a and c
G == 10: @assert not a
G == 20: @assert a and b
G == 30: p = 60
G == 30: @assert a and not b
G == 40: p = 0
G == 40: @assert not a and not c
G == 50: p = 6
G == 60: @assert not a
G == 70: @assert a and b
G == 80: @assert a and b
G == 80: @stop
