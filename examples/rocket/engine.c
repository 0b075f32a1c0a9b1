// SPDX-License-Identifier: Apache-2.0
// The engine task: the valve is open while the task is enabled, and shut while it is safed.
#include "rocket_app.h"

SmResult engine_step(const SmTick *tick)
{
    (void)tick;
    rocket_set_engineValve(true);
    return SM_OK;
}

SmResult engine_safe(const SmTick *tick)
{
    (void)tick;
    rocket_set_engineValve(false);
    return SM_OK;
}
