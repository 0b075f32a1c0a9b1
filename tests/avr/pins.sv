[Sensors]
U64  time
U32  state
F64  plain              # the volts themselves
F64  pressure
F32  level
I16  below
I64  wide
bool high
bool low
bool pulled

[Actuators]
F64  volts
F32  valve
I16  heater
U8   fan
bool lamp
bool dark
bool twin
