# Images of another version of a machine, and of another format. The table of parameters is part of the image: a newer source changes neither
# its names nor its ranges. An image of an older format is refused before its parameters are read, and no file is written.
args build old.sm -g
args build new.sm -g
args set old.smb limit=790 -o tuned.smb
args set old.smb gain=0.5 -o x.smb
args set old.smb limit=150 -o x.smb
args set new.smb limit=790 gain=0.5 -o x.smb
args set new.smb limit=150 gain=0.5 -o y.smb
args set tuned.smb && printf '\001' | dd of=tuned.smb bs=1 seek=3 conv=notrunc 2>/dev/null
args set tuned.smb
args set tuned.smb limit=750 -o x.smb
args verify tuned.smb; test -e x.smb || echo no file is written

-- old.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[local]
F64 limit = 775 @parameter @range 700 800
[Idle]
.step
    p > limit: -> Vent
[Vent] @safe
-- new.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[local]
F64 limit = 120 @parameter @range 100 200
F64 gain = 1 @parameter @range 0 2
[Idle]
.step
    p * gain > limit: -> Vent
[Vent] @safe
-- stdout --
logic 7b65712cc44c1777, settings e274921c5c65cdf5
limit = 790 (F64, 700 to 800, default 775)
no file is written
-- stderr --
smc: cannot set parameter 'gain' to 0.5: the machine has no such parameter
smc: cannot set parameter 'limit' to 150: the value is below the range
smc: cannot set parameter 'limit' to 790: the value is above the range
smc: tuned.smb: refused, because rule 2 is violated at byte 3: its format version is 2
smc: it was made by another version of smc: build it again with this one, from its sources
smc: tuned.smb: refused, because rule 2 is violated at byte 3: its format version is 2
smc: it was made by another version of smc: build it again with this one, from its sources
smc: tuned.smb: refused, because rule 2 is violated at byte 3: its format version is 2
smc: it was made by another version of smc: build it again with this one, from its sources
-- exit --
0 0 0 1 1 1 0 0 1 1 0
