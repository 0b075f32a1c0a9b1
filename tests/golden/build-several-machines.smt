# Several machines over one state vector make one image.
args build --sv=v.sv a.sm b.sm -o all.smb
args verify all.smb

-- v.sv --
[Valves]
bool open
bool drain
[Sensors]
F32 pressure
U64 G
U32 S
U32 drainState
-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- b.sm --
[state_vector]
U64 G
U32 drainState @alias S
bool drain
[Idle]
.step
    drain = true
-- stdout --
all.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 32 bytes (layout fb8d6fee)
all.smb: machine 2: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 32 bytes (layout fb8d6fee)
