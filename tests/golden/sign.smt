# Images are signed with a key and looked at with it; keys are never overwritten.
args key k.key
args key k.key
args build a.sm
args verify a.smb --key=k.key
args sign a.smb --key=k.key --number=7
args verify a.smb
args verify a.smb --key=k.key
args key other.key
args verify a.smb --key=other.key
args sign a.smb --key=other.key --number=4000000000 -o b.smb
args verify b.smb --key=other.key
args key
args key -
args sign a.smb
args sign --key=k.key
args sign a.smb --key=a.sm
args sign a.smb --key=missing.key
args sign a.sm --key=k.key
args sign a.smb --key=k.key --number=0
args sign a.smb --key=k.key --number=4000000001
args sign a.smb --key=k.key --number=7x
args build a.sm --key=k.key

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
k.key: key [..]
a.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout b1dc9237)
a.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout b1dc9237)
a.smb: signed with key [..], number 7
a.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout b1dc9237)
a.smb: signed with this key [..], number 7
other.key: key [..]
a.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout b1dc9237)
b.smb: machine 1: 1 state, longest step 3 instructions, [..] bytes of RAM on a 64-bit computer, state vector 16 bytes (layout b1dc9237)
b.smb: signed with this key [..], number 4000000000
-- stderr --
smc: cannot create 'k.key': File exists
smc: a.smb is not signed
smc: a.smb is signed with key [..], but 'other.key' is key [..]
smc: key requires the name of a new file, as in 'smc key rocket.key'
Try 'smc key --help'.
smc: key requires the name of a new file, as in 'smc key rocket.key'
Try 'smc key --help'.
smc: sign requires an image and a key, as in 'smc sign tank.smb --key=rocket.key'
Try 'smc sign --help'.
smc: sign requires an image and a key, as in 'smc sign tank.smb --key=rocket.key'
Try 'smc sign --help'.
smc: 'a.sm' is not a key: a key is 32 hexadecimal digits; 'smc key FILE' makes one
smc: cannot read 'missing.key': No such file or directory
smc: a.sm: refused, because rule 1 is violated at byte 0: an image begins with the bytes 's' 'm' 'b'
smc: it is no image; 'smc build' makes one of a machine
smc: --number requires a whole number from 1 to 4000000000, not '0'
Try 'smc sign --help'.
smc: --number requires a whole number from 1 to 4000000000, not '4000000001'
Try 'smc sign --help'.
smc: --number requires a whole number from 1 to 4000000000, not '7x'
Try 'smc sign --help'.
smc: option '--key' is not an option of 'smc build'
Try 'smc build --help'.
-- exit --
0 3 0 1 0 0 0 0 1 0 0 2 2 2 2 1 3 1 2 2 2 2
