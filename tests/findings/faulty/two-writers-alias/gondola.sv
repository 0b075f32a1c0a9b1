# SPDX-License-Identifier: Apache-2.0
# Stratospheric gondola.

[Time]
U64  time

[Commands]
bool ballastCommand
bool parachuteArmed

[Sensors]
F32  altitude           # m
F32  climb              # m/s

[Actuators]
F32  ballastRate        # g/s
bool cutter
bool lamp

[States]
U32  floatState
U32  cutState
