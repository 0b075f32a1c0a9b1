spec 8.21  G never becomes 18446744073709551615: reaching it is the same error.
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
delta_t 5755614375572403   #! E0752

[all_states]
G == 7: @stop   #! W0702
