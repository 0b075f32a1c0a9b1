spec 2.24  @unit follows elements, locals and definitions, and changes nothing, not even where units differ.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m
F64 b @unit ft
F64 c
[local]
F64 kept = 1 @unit s

[define]
limit = 3 @unit psi
time = a * b @unit m^2

[Run] @safe
.step
    a = b
    c = a + time
    kept = kept + limit

-- app.ss --
[options]
delta_t 10

[local]
F64 gain = 7 @unit m

[all_states]
G == 0: b = gain
G == 10 {
    @assert a == 7
    @assert c == 7 + 49
    @assert kept == 7
    @stop
}
