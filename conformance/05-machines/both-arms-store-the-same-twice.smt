spec 5.9, 2.6  What both arms store alike is stored, and nothing else is known of it than that.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool x
U8 byte
U8 none

[Only]
.entry
    if p > 5: x = false
    else: x = false
    none = x * 300
.step
    if p > 5: x = true
    else: x = true
    byte = x * 300

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert byte == 255 and none == 0
G == 4: @stop
