# Errors that are reported before the board is contacted.
args build a.sm
args flash a.smb
args flash
args flash a.smb --port=nowhere
args flash a.smb --port=a.sm
args flash a.smb --port=a.sm --speed=9601
args flash a.smb --port=a.sm --speed=fast
args flash a.smb --port=a.sm --period=0
args flash a.smb --port=a.sm --period=20s
args flash a.sm --port=nowhere
args flash missing.smb --port=nowhere

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: flash requires --port, the serial line to the board, as in --port=/dev/ttyACM0
Try 'smc flash --help'.
smc: flash requires one image, as in 'smc flash tank.smb --port=/dev/ttyACM0'
Try 'smc flash --help'.
smc: cannot open 'nowhere': No such file or directory
smc: cannot open 'a.sm': it is no serial line
smc: cannot open 'a.sm': there is no such speed (115200 is the firmware's)
smc: --speed requires a number of bits per second, not 'fast'
Try 'smc flash --help'.
smc: --period requires whole milliseconds from 1 to 65535, as in --period=20, not '0'
Try 'smc flash --help'.
smc: --period requires whole milliseconds from 1 to 65535, as in --period=20, not '20s'
Try 'smc flash --help'.
smc: flash requires an image: 'smc build a.sm' makes one
Try 'smc flash --help'.
smc: cannot read 'missing.smb': No such file or directory
-- exit --
0 2 2 3 3 3 2 2 2 2 3
