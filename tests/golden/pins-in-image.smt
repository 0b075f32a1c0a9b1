# An image can carry pins.
args build hold.sm --sv app.sv --io app.io -o app.smb -MD && cat app.d
args disasm app.smb | sed -n '/^pins/,/^$/p'
args verify app.smb | sed 1d
args build hold.sm --sv app.sv --io time.io
args build hold.sm --io app.io
args build hold.sm --sv app.sv --io app.io --emit=c
args build hold.sm --sv app.sv --io gone.io

-- app.sv --
[Sensors]
F64 pressure
bool limit
[Time]
U64 G
U32 S
-- hold.sm --
[state_vector]
U64 G
U32 S
F64 pressure
[Hold]
.step
    pressure > 5: -> Vent
[Vent]
-- app.io --
[analog]
i 0 pressure @scale 250 @offset -125 @hold 3
[digital]
i 1 limit @inverted @pull_up
-- time.io --
[analog]
i 0 G
-- stdout --
app.smb: hold.sm app.sv app.io
pins
    state vector    32 bytes, layout 3df7964d
    analog i 0      F64 at 0 @scale 250 @offset -125 @hold 3
    digital i 1     bool at 8 @inverted @pull_up

app.smb: pins: analog input 0, digital input 1 with @pull_up
-- stderr --
time.io:2:5: error: 'G' is the time, G, of machine 'hold', and cannot be an input [E1187]
    2 | i 0 G
      |     ^
hold.sm:2:5: note: machine 'hold' lists it here
1 error
smc: --io adds pins to an image, with the state vector that --sv names, as in 'smc build tank.sm --sv app.sv --io app.io'
Try 'smc build --help'.
smc: --io adds pins to an image, with the state vector that --sv names, as in 'smc build tank.sm --sv app.sv --io app.io'
Try 'smc build --help'.
smc: cannot read 'gone.io': No such file or directory
-- exit --
0 0 0 1 2 2 3
