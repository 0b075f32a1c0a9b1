# The report of a script, to the letter.

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
-- tank.ss --
# The pressure climbs by 1 psi a step while the valve is shut and falls by 1 while it is open.

[options]
delta_t    10
init_state TankVentControl

[all_states]
G == 0 {
    tankPressure = 600
    valveOpen    = false
}
valveOpen:  tankPressure = tankPressure - 1
!valveOpen: tankPressure = tankPressure + 1
G == 1000:  @stop

[TankVentControl]
true: @assert valveOpen == (tankPressure > 775)
-- report --
state script ran for 101 steps
100 asserts passed
final state vector:
  G = 1000
  P_AbortThreshold = 825
  P_WarnThreshold = 800
  S = 1
  T = 1000
  counter = 0
  pi = 3.141590
  tankPressure = 701.000000
  valveOpen = false
