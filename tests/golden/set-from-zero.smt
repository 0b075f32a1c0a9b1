# A range that begins at 0 is listed so, although its end in the image is -0.
args build a.sm -g
args set a.smb
args set a.smb gain=-0 limit=-0 -o b.smb
args verify b.smb
args set a.smb gain=-1 -o c.smb

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F32 gain = 0.5 @parameter @range 0 1
F64 limit = 0 @parameter @range -3 0
[Run] @safe
.step
    x = gain + limit
-- stdout --
logic [..], settings [..]
limit = 0 (F64, -3 to 0, default 0)
gain = 0.5 (F32, 0 to 1, default 0.5)
b.smb: machine 1: 1 state, longest step 5 instructions, 112 bytes of RAM on a 64-bit computer, state vector 24 bytes (layout c7de1feb)
-- stderr --
smc: cannot set parameter 'gain' to -1: the value is below the range
-- exit --
0 0 0 0 1
