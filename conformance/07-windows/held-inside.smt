spec 7.27, 7.5  Inner functions sample before outer ones.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
bool b
bool c
[Run]
.step
    a = roll_avg(held(p > 1, 2 steps), 2)        #! W0425
    b = held(roll_max(p, 2) > 1, 20 ms)        #! W0425
    c = rising(held(prev(p) > 1, 10 ms))        #! W0425

-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 2
G == 0: @assert a == 0 and not b
G == 10: @assert a == 0.5 and not b and c
G == 20: p = 0
G == 20: @assert a == 0.5 and b and not c
G == 30: @assert not b
G == 30: @stop
