spec 5.9, 2.6  What both arms store alike is stored, and known to be behind them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool a
bool x
U8 byte

[First]
.step
    if a {
        if p > 5: x = false
        else: x = false
    } else: x = true
    byte = x * 300
    -> Second
[Second]
.step
    if a {
        if p > 5: x = true
        else: x = true
    } else: x = false
    byte = x * 300

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: a = 1
G == 0: @assert byte == 0
G == 1: @assert byte == 255
G == 4: @stop
