# A state vector that two machines share.
[Time]
U64 G
U32 S
U32 S2
[Tank]
F64 pressure
bool valveOpen
bool pumpOn
[Sensors]
F32 temperature
