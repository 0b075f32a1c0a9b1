// SPDX-License-Identifier: Apache-2.0
// The tasks of probe.app.  They print what they receive, so that the order and the number of all calls can be compared.
#include <stdio.h>

#include "probe_app.h"

SmResult first_init(void)
{
    printf("init %.6g %d %d %d %.6g\n", probe_pressure(), (int)probe_mode(), (int)probe_offset(), (int)probe_armed(),
           (double)probe_gain());
    return SM_OK;
}

SmResult first_step(const SmTick *tick)
{
    printf("first %lu at %lu\n", (unsigned long)tick->number, (unsigned long)probe_time());
    if (tick->number == 3)
        probe_set_mode(SM_ENABLED);
    if (tick->number == 6)
        probe_set_mode(SM_DISABLED);
    if (tick->number == 10)
        sm_app_stop(&probe_app);
    return SM_OK;
}

SmResult last_step(const SmTick *tick)
{
    (void)tick;
    printf("last: state %u, %.6g\n", (unsigned)probe_probeState(), probe_pressure());
    return SM_OK;
}

SmResult last_safe(const SmTick *tick)
{
    (void)tick;
    printf("safed\n");
    return SM_OK;
}

SmResult slow_step(const SmTick *tick)
{
    printf("slow %lu, %u ticks\n", (unsigned long)tick->number, (unsigned)probe_ticks());
    return SM_OK;
}
