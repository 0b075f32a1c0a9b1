# SPDX-License-Identifier: Apache-2.0
# What the two boards of the sounding rocket tell each other.

[Time]
U64  time             # ms since power-on

[Sensors]
bool breakWire        # still whole: the rocket is on the rail
F32  altitude         # m above the pad
F32  acceleration     # m/s2 along the axis

[Flight]
U32  flightState
bool ejectAllowed     # the recovery may fire
bool payloadPower

[Recovery]
U32  recoveryState
bool drogue
bool mainChute
