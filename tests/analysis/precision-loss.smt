# Beyond 2^53: literals, and sums with something small.
warn precision-loss no-dead-store no-constant-guard no-unused-local no-duplicate-guard no-shadowed-transition
-- app.sm --
[state_vector]
U64 G
U32 S
I64 code @read_only
F64 p @read_only
U64 wide
F64 x
[local]
U64 huge = 9007199254740992
U64 last = 18446744073709551615 @read_only
F64 odd = 0x20000000000001 @read_only         #! W0415 0x20000000000001 is too large to be exact: its value is 9007199254740992
[Hold]
.step
    code == 9007199254740993: -> Hold         #! W0415 9007199254740993 is too large to be exact: its value is 9007199254740992
    code == -9_007_199_254_740_995: -> Hold   #! W0415
    huge = huge + 1                           #! W0416
    p > 9007199254740992: x = p - 1           #! W0416
    p > 9007199254740992: x = p - 2048
    code == 9007199254740994: -> Hold
    code == 9007199254740992: -> Hold
    wide = last
    code == 9223372036854775807: -> Hold
    wide = 9007199254740992 + 2
    wide = code + 1
    G > 10: x = G - 1
    x = 1e30
    x = 18455751272964292609
    x = 0.1
