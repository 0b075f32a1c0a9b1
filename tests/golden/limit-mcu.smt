# A machine that the firmware of the chip cannot run: a function that it lacks, too much RAM. The report
# names the smallest board that can run the machine.
args build a.sm --mcu=atmega328p
args build a.sm --mcu=atmega2560
args check b.sm --mcu=atmega328p
args check b.sm --mcu=atmega2560
args check c.sm --mcu=atmega328p
args check a.sm --mcu=uno
args build a.sm --mcu=atmega328p --emit=c
args report a.sm --format=text
args report c.sm --format=text

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[define]
altitude = 44330 * (1 - pow(p / 1013.25, 0.19))
[Run] @safe
.step
    x = altitude
    x = max(x, roll_max(exp(p), 3))
-- b.sm --
[state_vector]
U64 G
U32 S
F32 p
F64 x
[Run] @safe
.step
    x = roll_max(p, 300)
-- c.sm --
[state_vector]
U64 G
U32 S
F64 p
[Run] @safe
.step
    p = sqrt(abs(p)) + exp(1)      # a constant, which no board computes
-- stdout --
...
  On an Arduino Mega  about [..]
...
On an Arduino Mega
...
  On an Arduino Uno[..]about [..]
...
-- stderr --
a.sm:7:25: error: pow() is called by machine 'a', and the firmware of the atmega328p (Uno) does not have it [E0864]
    7 | altitude = 44330 * (1 - pow(p / 1013.25, 0.19))
      |                         ^~~~~~~~~~~~~~~~~~~~~~ the firmware of a Mega has it
a.sm:11:25: error: exp() is called by machine 'a', and the firmware of the atmega328p (Uno) does not have it [E0864]
   11 |     x = max(x, roll_max(exp(p), 3))
      |                         ^~~~~~ the firmware of a Mega has it
2 errors
b.sm:1:1: error: machine 'b' needs 1232 bytes of RAM, but the firmware of the atmega328p (Uno) has room for 960 [E0865]
    1 | [state_vector]
      | ^
1 error
smc: --mcu is atmega328p or atmega2560, not 'uno'
Try 'smc check --help'.
smc: --mcu, --max-ram, --max-step and --max-cycles apply to bytecode, not to --emit=c
Try 'smc build --help'.
-- exit --
1 0 1 0 0 2 2 0 0
