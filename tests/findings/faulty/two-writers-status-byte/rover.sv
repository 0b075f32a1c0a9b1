# SPDX-License-Identifier: Apache-2.0
# Test rover on the lander's ramp.

[Time]
U64  time

[Radio]
bool driveCommand
bool heatCommand

[Sensors]
F32  wheelCurrent       # A
F32  motorTemp          # degrees C

[Actuators]
bool drive
bool heater
bool busy               # the radio tells the operator: something runs

[States]
U32  driveState
U32  heatState
