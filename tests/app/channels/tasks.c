// SPDX-License-Identifier: Apache-2.0
// The tasks of channels.app: the flight, and what the igniters make of it.
#include <stdio.h>

#include "channels_app.h"

SmResult plant_step(const SmTick *tick)
{
    if (tick->number == 1)
        channels_set_apogee(true);
    if (tick->number == 4)
        channels_set_go(true);
    if (tick->number == 10)
        sm_app_stop(&channels_app);
    return SM_OK;
}

SmResult show_step(const SmTick *tick)
{
    printf("%lu: drogue %u %d, main %u %d, spare %u %d\n", (unsigned long)tick->number, (unsigned)channels_drogueState(), (int)channels_fireDrogue(),
           (unsigned)channels_state(), (int)channels_fire(), (unsigned)channels_spareState(), (int)channels_fireSpare());
    return SM_OK;
}
