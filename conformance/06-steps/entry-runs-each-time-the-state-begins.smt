spec 6.7  And again whenever the state is entered.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
U8 m

[A]
.entry
    n = n + 1
.step
    T == 1: -> B
[B]
.entry
    m = m + 1
.step
    -> A

-- app.ss --
[options]
delta_t 1

[all_states]
G == 2: @assert n == 1 and m == 1
G == 3: @assert n == 2
G == 5: @assert m == 2
G == 6: @assert n == 3
G == 6: @stop
