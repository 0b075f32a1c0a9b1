spec 5.47  @range takes two numbers, each with or without a sign, the lower one first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @read_only @range 0 40
F64 b @range -40 - 0.5 @alias bb
I16 c @range +3 3
F32 d @range
    -1
    1
F64 e

[Run]
.step
    e = a + bb + c + d

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 41
    b = 1
    c = 1
    d = 2
    @assert e == 45
    @stop
}
