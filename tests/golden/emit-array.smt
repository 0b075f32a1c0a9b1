# The bytecode as a C array, in a header named after the machine; --prefix names what it declares.
args build --emit=array --prefix=valve a.sm && ls && grep -c 'static const uint8_t valve_image' a_image.h

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a.sm
a_image.h
1
