spec 2.3   A U64 is rounded when it is read: 2^53 + 1 compares as 2^53, against a constant too.

-- app.sm --
[state_vector]
U64 G
U32 S
bool le
bool gt
bool eq
bool ne
bool ge
bool lt
bool mirrored
bool above

[Run]
.step
    le = G <= 9007199254740992
    gt = G > 9007199254740992
    eq = G == 9007199254740992
    ne = G != 9007199254740992
    ge = G >= 9007199254740992
    lt = G < 9007199254740992
    mirrored = 9007199254740992 >= G
    above = G > 9007199254740991

-- app.ss --
[options]
delta_t 3002399751580331        # three of them are 2^53 + 1

[all_states]
G == 9007199254740992 {
    @assert le == 1
    @assert gt == 0
    @assert eq == 1
    @assert ne == 0
    @assert ge == 1
    @assert lt == 0
    @assert mirrored == 1
    @assert above == 1
    @stop
}
