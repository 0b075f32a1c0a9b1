# The device's own checks.
args build a.sm
args verify a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout b1dc9237)
