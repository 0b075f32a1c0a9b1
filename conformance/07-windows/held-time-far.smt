spec 7.32  The time is exact, also where G is beyond 2^53.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool a
bool b
[options]
time_unit us
[Run]
.step
    a = held(G >= 9223372036854775808, 3 us)        #! W0425
    b = held(G >= 9223372036854775808, 1 us)        #! W0425

-- app.ss --
[options]
delta_t 9223372036854775808
[all_states]
G == 0: @assert not a and not b
G > 0: @assert not a and not b
G > 0: @stop
