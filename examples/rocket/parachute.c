// SPDX-License-Identifier: Apache-2.0
// The parachute task: enabled, it fires the charge that frees the parachute: half a second of current, once, then none.
#include "rocket_app.h"

static const uint16_t fireSteps = 50;        // of 10 ms

SmResult parachute_step(const SmTick *tick)
{
    bool fire = rocket_chargeSteps() < fireSteps;

    (void)tick;
    if (fire)
        rocket_set_chargeSteps((uint16_t)(rocket_chargeSteps() + 1));
    rocket_set_parachuteCharge(fire);
    return SM_OK;
}

SmResult parachute_safe(const SmTick *tick)
{
    (void)tick;
    rocket_set_parachuteCharge(false);
    return SM_OK;
}
