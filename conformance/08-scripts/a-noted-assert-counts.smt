spec 8.17, 8.18  An assert whose guard was true before the step is judged, although the guard is false after it.
expect fail

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
G == 0: p = 7
x == 0: @assert x == 8   #! E0750
G == 0: @stop
