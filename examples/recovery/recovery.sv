# The state vector of a small rocket's recovery computer.

[Time]
U64  time  @unit ms  # since power-on

[Altimeter]
F32  altitude @range -20 400  @unit m  # above the pad

[Recovery]
U32  state
bool drogueCharge       # current through the igniter of the small parachute
bool mainCharge         # current through the igniter of the large one
