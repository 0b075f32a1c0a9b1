spec 8.5  Conditionals with and without if and braces.

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
G == 0: p = 1
if G == 0: k = 2
G == 0 { c = 3 }   #! W0701
if G == 0
{
    ro = 4
    p = p + 10
    k = k + 10
}
G == 0: @assert x == 11 and k == 12 and c == 3 and ro == 4
G == 0: @stop
