spec 8.10  Inputs may write read-only elements and locals, under any of their names.

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
G == 0 {
    ro = 1
    k = 2
    c = 3   #! W0701
}
G == 1: q = ro + 10
G == 0: @assert ro == 1 and k == 2 and c == 3
G == 1: @assert q == 11 and ro == 11
G == 1: @stop
