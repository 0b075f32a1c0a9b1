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
