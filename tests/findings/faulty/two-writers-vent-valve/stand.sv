# SPDX-License-Identifier: Apache-2.0
# Test stand: the state vector of the stand computer.

[Time]
U64  time

[Sensors]
F32  tankPressure       # bar
bool fillOrder
bool ventOrder

[Valves]
bool fillValve
bool ventValve

[States]
U32  fillState
U32  ventState
