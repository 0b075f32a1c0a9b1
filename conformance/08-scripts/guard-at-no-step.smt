spec 8.42  `at` with a time that no step has is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[all_states]
at 15: p = 1                #! E0757 the nearest are 10 ms and 20 ms
at 15: @assert x == 1       #! E0757 no step has G = 15: G advances by 10 ms
at 0.5: p = 1               #! E0757
at 12.5 ms: p = 1           #! E0757
at 100: @stop
[Burn]
at 20.5: p = 1              #! E0757
