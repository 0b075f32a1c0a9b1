spec 8.15  Windows of a section sample although another section is active.

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
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 2: p = 99
G == 3: p = 2
G == 5: @stop

[B]
G == 4: @assert roll_max(p, 5) == 99 and roll_range(p, 5) == 99 and roll_avg(p, 2) == (99 + 2) / 2
