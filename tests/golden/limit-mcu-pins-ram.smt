# The pins that --io names take RAM on the board, so they count: without them the Uno has room for the machine.
args check a.sm --sv app.sv --mcu=atmega328p
args build a.sm --sv app.sv --io app.io --mcu=atmega328p -o a.smb
args build a.sm --sv app.sv --io one.io --mcu=atmega328p -o b.smb
args build a.sm --sv app.sv --io app.io --mcu=atmega2560 -o c.smb

-- a.sm --
[state_vector]
U64 G
U32 S
F32 p
F64 x
[Run] @safe
.step
    x = roll_max(p, 224)
-- app.sv --
[Sensors]
U64 G
U32 S
F32 p
F64 x
-- app.io --
[analog]
i 0 p
o 9 x @safe 0
-- one.io --
[analog]
i 0 p
-- stderr --
a.sm:1:1: error: machine 'a' needs 980 bytes of RAM, but the firmware of the atmega328p (Uno) has room for 960 [E0865]
    1 | [state_vector]
      | ^
1 error
-- exit --
0 1 0 0
