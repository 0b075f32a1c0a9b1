<<<<<<< HEAD
# The state vector of the rocket: everything that its parts tell each other. Each machine lists what it needs of it.

[Time]
U64  time               # ms since power-on

[Sensors]
bool umbilical          # the cable to the ground is still plugged in
F32  acceleration       # m/s2 along the rocket, without gravity: 0 in free fall, 9.8 on the pad
F32  velocity           # m/s upwards, from the navigation filter
F32  altitude           # m above the pad, from the same filter

[Mission]
U32  missionState
bool mayBrake           # the mission allows the airbrakes to come out
bool deployParachutes   # order to the parachute electronics

[Airbrakes]
U32  airbrakeState
F32  brakeOrder         # 0 in, 1 all the way out
F32  brakePosition      # what the sensor on the drive says
=======
# The state vector of the whole rocket: every task reads and writes here.

[options]
lock

[Clock]
U64  time                 # ms since power-up

[Sensors]
F64  altitude             # m above the pad
F64  acceleration         # m/s^2 along the rocket
F64  chamberPressure      # bar
bool umbilical            # true while the cable to the pad is connected

[Commands]
bool launchCommand        # from the ground
bool abortCommand

[Tasks]
U8   engineMode           # 0 off, 1 run, 2 safe
U8   recoveryMode
U8   telemetryRate        # frames a second

[Mission]
U32  missionState
F64  apogee               # m, the highest altitude of the flight
>>>>>>> 46725a9 (examples: mission, ignition, parachutes, chill-down, with their tests; docs: tour; check-docs, check-examples, mutants)
