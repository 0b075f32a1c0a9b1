# The application lists what anything but its swappable machines stores: a new machine must not store it.
args build stand.app && grep -A8 'written.]' stand_app.c

-- stand.sv --
[A]
U64 time
U32 fillState
U32 ventState
F64 pressure
F64 order
U32 orderAge
U32 lost
U32 late
bool fillOpen
bool ventOpen
-- stand.io --
[analog]
i  3  pressure  @scale 250
-- stand.net --
receive orders on 5001 @timeout 500 ms @age orderAge @count late lost {
    order @default 0
}
-- fill.sm --
[state_vector]
U64 time @alias G
U32 fillState @alias S
F64 order @read_only
bool fillOpen
[Idle] @swap
.step
    fillOpen = order > 0
-- vent.sm --
[state_vector]
U64 time @alias G
U32 ventState @alias S
F64 pressure @read_only
bool ventOpen
[Idle]
.step
    ventOpen = pressure > 700
-- stand.app --
[options]
state_vector "stand.sv"
io           "stand.io"
net          "stand.net"
time         time 1 ms
swap         16 KB
[control] @late late
every 10 ms:
    inputs
    receive
    machine fill "fill.sm" @bytecode @swap
    machine vent "vent.sm"
-- stdout --
static const SmRange written[] = {
    {0, 8},      // time
    {12, 4},      // ventState
    {16, 8},      // pressure
    {24, 8},      // order
    {32, 4},      // orderAge
    {36, 4},      // lost
    {40, 4},      // late
    {45, 1},      // ventOpen
