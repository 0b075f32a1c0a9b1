// SPDX-License-Identifier: Apache-2.0
// The tasks of stand.app: a sensor with oscillating readings, a valve with a safe position, and a task that prints the state vector in its wire
// form, one line of hexadecimal digits per tick.
#include <stdio.h>

#include "stand_app.h"

enum { TICKS = 60, ROOM = 128 };

SmResult sensors_step(const SmTick *tick)
{
    const uint32_t n = (uint32_t)tick->number;

    stand_set_reading((int16_t)((n * 37 % 101) * (n / 20 + 5) + 600));
    if (n % 16 == 9)
        stand_set_mode(SM_DISABLED);
    if (n == TICKS)
        sm_app_stop(&stand_app);
    return SM_OK;
}

SmResult valve_step(const SmTick *tick)
{
    (void)tick;
    stand_set_valve((uint8_t)(stand_valve() + (stand_open() ? 3 : 1)));
    return SM_OK;
}

SmResult valve_safe(const SmTick *tick)
{
    (void)tick;
    stand_set_valve(100);
    return SM_OK;
}

SmResult slow_step(const SmTick *tick)
{
    stand_set_slowly(stand_slowly() * 7 + (uint32_t)tick->number);
    return SM_OK;
}

SmResult tell_step(const SmTick *tick)
{
    static uint8_t bytes[ROOM];
    const SmRegion *all = sm_find_region(&stand_names, "*");
    const SmResult r = all ? sm_pack_region(&stand_vector, all, bytes, sizeof bytes) : SM_E_MISSING;

    (void)tick;
    for (uint16_t i = 0; r == SM_OK && i < all->packed; i++) {
        putchar("0123456789abcdef"[bytes[i] >> 4]);
        putchar("0123456789abcdef"[bytes[i] & 15]);
    }
    putchar('\n');
    return r;
}
