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
