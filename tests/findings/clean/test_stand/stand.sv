# SPDX-License-Identifier: Apache-2.0
# State vector of the engine test stand. Pressures in bar absolute.

[Time]
U64  time

[Console]
bool key
bool fireButton

[Sensors]
F32  tankPressure    @range 0.5 60
F32  bottlePressure  @range 0.5 320
F32  chamber         @range 0.5 45
U8   valveFeedback   @range 0 100        # percent open

[Feed]
U32  feedState
bool pressValve
bool tankVent
bool feedReady

[Engine]
U32  engineState
bool igniter
bool mainValve
bool burning
