# What pins.io connects.
[options]
lock

[Time]
U64 time
U32 state

[Sensors]
F64 pressure
F32 flow
I8 small
U16 count
I64 wide
bool limit
bool door
bool float

[Actuators]
F64 heater
U8 fan
bool valve
bool vent
