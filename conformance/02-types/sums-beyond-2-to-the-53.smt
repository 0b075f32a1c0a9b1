spec 2.6   Arithmetic rounds to F64, of whole numbers too: 2^53 + 1 is 2^53.

-- app.sm --
[state_vector]
U64 G
U32 S
U32 n
F64 up
F64 down
F64 lost
I64 wide

[Run]
.step
    up = 1 - (n - 9007199254740992)
    down = (n - 9007199254740992) - 1
    lost = 1 - (n - 9007199254740992) - 1
    wide = 2 - (n - 9007199254740992) + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    @assert up == 9007199254740992
    @assert down == -9007199254740992
    @assert lost == 9007199254740991
    @assert wide == 9007199254740996
}
G == 1: n = 1
G == 1 {
    @assert up == 9007199254740992
    @assert down == -9007199254740992
    @assert wide == 9007199254740992
    @stop
}
