spec 6.5  T is 0 at the first step of a state and grows like G; at the first step of the next state it is 0 again.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[A]
.step
    x = T
    T == 20: -> B

[B]
.entry
    y = T
.step
    x = T
    T == 10: -> A

-- app.ss --
[options]
delta_t 10

[all_states]
G == 0: @assert x == 0 and T == 0 and S == 1
G == 10: @assert x == 10 and T == 10 and S == 1
G == 20: @assert x == 20 and T == 20 and S == 1
G == 30: @assert x == 0 and T == 0 and S == 2
G == 40: @assert x == 10 and T == 10 and S == 2
G == 50: @assert x == 0 and T == 0 and S == 1
G == 60: @assert x == 10 and T == 10 and S == 1
G == 60: @stop
