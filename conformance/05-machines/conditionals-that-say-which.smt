spec 5.9, 2.6  Branches that only store a truth value or count do exactly that, whichever branch is taken.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool open
bool shut
bool always
bool flips
bool inner
bool lit

[local]
U64 ups     = 0
U64 downs   = 5
U8  byte    = 250
I8  small   = -126
U16 word    = 65533
I16 short   = 0
U32 wide    = 4294967290
I32 long    = 0
I64 huge    = -9007199254740989
U64 far     = 9007199254740990
U32 guarded = 0
F32 single  = -0.0
U8  both    = 0
bool latch  = false
U8  seen    = 0
I16 unseen  = 0

[Run]
.entry
    if p > 5: open = true
    else: open = false
.step
    if p > 5 {
        open = true
        shut = false
        always = true
        ups = ups + 1
        byte = byte + 1
        word = 1 + word
    } else {
        open = false
        shut = true
        always = true
    }
    if p > 5 {
        downs = downs - 1
        short = short - 1
    } else {
        small = small - 1
        long = long + 1
    }
    if p > 5: seen = seen + 1
    else: unseen = unseen - 1
    if flips: flips = false
    else: flips = true
    if p <= 5: guarded = 4000000000
    if guarded < 100: guarded = guarded + 1
    if p > 5: wide = wide + 1
    if not (p > 5): huge = huge - 1
    if p > 5: far = far + 1
    if p > 5: single = single + 1
    if p > 5: both = both + 1
    else: both = both + 2
    if p > 5 {
        if p > 7: inner = true
        else: inner = false
    } else: inner = false
    if p > 5: latch = true
    p > 100: -> Done
    if p > 5 and ups > 1: lit = true
    else: lit = false
.exit
    if p > 200: open = false
    else: open = true

[Done]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 6
G == 0: @assert open and not shut and always and flips and not inner and latch and not lit
G == 0: @assert ups == 1 and downs == 4 and byte == 251 and word == 65534 and short == -1 and small == -126 and long == 0
G == 0: @assert wide == 4294967291 and far == 9007199254740991 and single == 1 and both == 1 and guarded == 1
G == 1: p = 8
G == 1: @assert open and not flips and inner and lit
G == 1: @assert ups == 2 and downs == 3 and byte == 252 and word == 65535 and short == -2 and far == 9007199254740992
G == 2: p = 5
G == 2: @assert not open and shut and always and flips and not inner and latch and not lit
G == 2: @assert ups == 2 and downs == 3 and byte == 252 and word == 65535 and small == -127 and long == 1 and both == 4
G == 2: @assert guarded == 4000000000 and huge == -9007199254740990 and far == 9007199254740992
G == 4: @assert seen == 2 and unseen == -3
G == 4: @assert small == -128 and long == 3 and both == 8 and huge == -9007199254740992
G == 5: p = 8
G == 5: @assert far == 9007199254740992 and wide == 4294967293 and word == 65535 and downs == 2
G == 11: @assert byte == 255 and wide == 4294967295 and downs == 0 and ups == 9
G == 12: p = 101
G == 12: @assert huge == -9007199254740992 and S == 1 and open and flips
G == 13: @assert S == 2
G == 13: @stop
