# The state vector of a recovery computer with two igniters.

[Time]
U64  time               # ms since power-on

[Altimeter]
F64  altitude @range -100 4000    # m above the pad

[Decisions]
U32  flightState
bool apogee             # falling since the highest point
bool low                # low enough for the main

[Igniters]
bool armed    @command  # the pin is pulled
U32  drogueState
U32  mainState
bool drogueFire         # current through the igniter of the drogue
bool mainFire           # current through the igniter of the main

[World]
F64  speed              # m/s, upwards; the plant's own
