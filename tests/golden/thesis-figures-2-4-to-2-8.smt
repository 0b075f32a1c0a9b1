# The figures of the thesis to the letter: the state vector of 2.4, the machine of 2.5 to 2.7, the script of 2.8; with the report of 3.4.
args check vector.sv
args test --engine=all tank.sm tank.ss

-- vector.sv --
[options]
lock

[SensorsRegion]
F64 tankPressure
F64 verticalAcceleration

[EffectorsRegion]
bool valveOpen
I8 finAngle
-- tank.sm --
[state_vector]
U64  time           @alias G
U32  state          @alias S
F64  tankPressure  @read_only
bool  valveOpen

[local]
F64  pi              = 3.14159 @read_only
U16  P_WarnThreshold = 800
U16  P_AbortThreshold = P_WarnThreshold + 25
U64  counter         = 0

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
-- stdout --
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
-- stderr --
tank.sm:8:6: warning: local 'pi' is never used [W0204 unused-local]
    8 | F64  pi              = 3.14159 @read_only
      |      ^~
tank.sm:9:6: warning: local 'P_WarnThreshold' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
    9 | U16  P_WarnThreshold = 800
      |      ^~~~~~~~~~~~~~~
tank.sm:10:6: warning: local 'P_AbortThreshold' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | U16  P_AbortThreshold = P_WarnThreshold + 25
      |      ^~~~~~~~~~~~~~~~
3 warnings
