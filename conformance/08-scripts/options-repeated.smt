spec 8.3  Of an option given several times the last value counts; [options] may stand several times, and last.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 5
delta_t 7
init_state A

[all_states]
G == 0: @assert S == 2
G == 20: @stop

[options]
init_state B
[options]
delta_t 10

-- trace --
1 G 0
2 G 10
3 G 20
