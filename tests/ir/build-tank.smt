# The machine of the examples: a conditional with an else, a chain whose middle is loaded once, transitions, constants.

-- tank.sm --
# Keeps the pressure of a propellant tank in its band by opening a vent valve.

[state_vector]
U64   time          @alias G
U32   state         @alias S
F64   tankPressure  @read_only      # psi
bool  valveOpen

[local]
F64  pi               = 3.14159 @read_only
U16  P_WarnThreshold  = 800
U16  P_AbortThreshold = P_WarnThreshold + 25
U64  counter          = 0

[TankVentControl]
.entry
    counter = 0
.step
    if tankPressure > 775 {
        valveOpen = true
        counter = counter + 1
    }
    else: valveOpen = false
    not (500 < tankPressure < P_AbortThreshold): -> Abort
    counter > 1000 and T > 4000: -> Idle
.exit
    valveOpen = true

[Idle]

[Abort]
-- ir out --
machine "tank"
vector "tank" size 32 hash 0x1ff9fb40

element U64 time at 0 is G
element U32 state at 8 is S
element F64 tankPressure at 16
element bool valveOpen writable at 24
local U16 P_WarnThreshold = 800
local U16 P_AbortThreshold = 825
local U64 counter writable = 0
time U64 T

state TankVentControl
entry {
b0:
    %0 = const F64 0
    %1 = cvt U64 %0
    store U64 counter, %1
    ret
}
step {
b0:
    %0 = load F64 tankPressure
    %1 = const F64 775
    %2 = gt F64 %0, %1
    br %2, b1, b2
b1:
    %3 = const F64 1
    %4 = cvt bool %3
    store bool valveOpen, %4
    %5 = load U64 counter
    %6 = cvt F64 %5
    %7 = const F64 1
    %8 = add F64 %6, %7
    %9 = cvt U64 %8
    store U64 counter, %9
    jmp b3
b2:
    %10 = const F64 0
    %11 = cvt bool %10
    store bool valveOpen, %11
    jmp b3
b3:
    %12 = const F64 500
    %13 = load F64 tankPressure
    %14 = lt F64 %12, %13
    %15 = load U16 P_AbortThreshold
    %16 = cvt F64 %15
    %17 = lt F64 %13, %16
    %18 = and %14, %17
    %19 = not %18
    br %19, b4, b5
b4:
    goto Abort
b5:
    %20 = load U64 counter
    %21 = cvt F64 %20
    %22 = const F64 1000
    %23 = gt F64 %21, %22
    %24 = load U64 T
    %25 = cvt F64 %24
    %26 = const F64 4000
    %27 = gt F64 %25, %26
    %28 = and %23, %27
    br %28, b6, b7
b6:
    goto Idle
b7:
    ret
}
exit {
b0:
    %0 = const F64 1
    %1 = cvt bool %0
    store bool valveOpen, %1
    ret
}

state Idle

state Abort
