# The state vector of the rocket: everything that its tasks tell each other, and everything that one of them has to remember
# from step to step. So a log of it is a log of the whole flight, and who keeps it can go on after a restart.

[Time]
U64  time  @unit ms  # since the start

[Raw]                     # as the converters deliver it; in this example the plant does
U16  rawAcceleration      # 0.1 m/s2 a count, 2000 is zero
U16  rawAirPressure       # 2 Pa a count
U16  rawTankPressure      # 0.01 bar a count

[Sensors]                 # by the sensor task
F32  acceleration  @unit m/s^2  # along the rocket, as it is felt: 9.8 on the pad, 0 in free fall
F32  airPressure   @unit Pa
F32  tankPressure  @unit bar

[Navigation]              # by the navigation task
F64  altitude     @unit m    # above the pad
F64  velocity     @unit m/s  # upwards
F64  padPressure  @unit Pa   # the air on the pad, averaged until lift-off
U8   unbelieved              # measurements in a row that lay too far from what was expected
U32  rejected                # how many altogether

[Mission]                 # by the mission machine
U32  missionState
bool flying               # the engine has been started
U8   engineMode           # 0 disabled, 1 safed: the valve is shut, 2 enabled: it is open
U8   parachuteMode        # 0 disabled, 1 safed: no current, 2 enabled: the charge is fired

[Effectors]
bool engineValve          # by the engine task
bool parachuteCharge      # by the parachute task: current through the charge that frees the parachute
U16  chargeSteps          # for how many steps it has flowed

[Health]                  # by the executor
U32  overruns        # steps that began when the next one was due
U32  late  @unit us  # that the last step began too late

[World]                   # by the plant, which stands for rocket and air; nothing that flies reads it
F64  trueAltitude  @unit m
F64  trueVelocity  @unit m/s
F64  propellant    @unit kg  # left
F64  canopy                  # how far the parachute is open, 0 to 1
U64  noise                   # state of the generator of random numbers
U16  stepsAtRest             # since it landed
