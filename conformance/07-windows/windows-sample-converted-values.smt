spec 7.8, 2.2  A sample is the value of an expression, here of bool and integer elements, and of a comparison.

-- app.sm --
[state_vector]
U64 G
U32 S
bool b
I8 n
F64 x
F64 y
F64 z

[Run]
.step
    x = roll_avg(b, 4)
    y = roll_min(n * n - n, 4)
    z = roll_avg(n > 0, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    b = true
    n = -3
}
G == 1: n = 2
G == 2: b = false
G == 3: @assert x == 0.5 and y == 2 and z == 0.75
G == 3: @stop
