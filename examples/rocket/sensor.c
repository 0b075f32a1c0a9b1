// SPDX-License-Identifier: Apache-2.0
// The sensor task: counts of the converters become units of physics.
#include "rocket_app.h"

SmResult sensor_step(const SmTick *tick)
{
    (void)tick;
    rocket_set_acceleration(0.1f * ((float)rocket_rawAcceleration() - 2000.0f));
    rocket_set_airPressure(2.0f * (float)rocket_rawAirPressure());
    rocket_set_tankPressure(0.01f * (float)rocket_rawTankPressure());
    return SM_OK;
}
