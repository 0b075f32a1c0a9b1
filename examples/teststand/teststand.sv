# The state vector of the test stand. Pressures are absolute and temperatures in kelvin, so that no healthy sensor ever reads 0:
# what cannot be read reads 0 in a machine.

[Time]
U64  time  @unit ms  # since the start

[Operator]
bool key                                 # held: fire; letting go of it is the stop button

[Sensors]                                # what they deliver while they are healthy is their range
F32  chamberPressureA  @range 0.5 50    @unit bar
F32  chamberPressureB  @range 0.5 50    @unit bar   # a second one beside it
F32  tankPressure      @range 0.5 55    @unit bar   # of the oxidizer
F32  lineTemperature   @range 60 350    @unit K     # where the oxidizer enters the engine: a thermocouple
F32  flow              @range -0.1 1.9  @unit kg/s  # of oxidizer
bool flame                                          # the igniter burns

[Monitor]
U32  monitorState
U8   sensorFault                         # 0 none, 1 chamber, 2 tank, 3 line, 4 flow, 5 the two in the chamber disagree, 6 computer

[Stand]
U32  standState
U8   abortReason                         # 0 none, 1 key, 2 sensor, 3 not cold, 4 igniter, 5 no thrust, 6 chamber pressure high,
                                         # 7 flame-out, 8 flow, 9 line warm, 10 tank, 11 does not stop

[Effectors]
bool igniter
bool oxidizerValve
bool fuelValve
bool chillValve                          # lets oxidizer through the line, to cool it, and into a basin
bool purgeValve                          # nitrogen through the chamber
bool ventValve                           # the tank's, to the open air

[Health]
U32  overruns        # steps that began when the next one was due
U32  late  @unit us  # that the last step began too late
