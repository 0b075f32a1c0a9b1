// SPDX-License-Identifier: Apache-2.0
// The simulated watchdog: records that it was not fed in time.  The program continues, so that the test can check.
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/watchdog.h"
#include "runtime-c/psl/sim/world.h"

#define LONGEST (60 * (uint64_t)PAL_SECOND)

static bool running, fired;
static uint64_t period, fed;

void sim_watchdog_reset(void)
{
    running = fired = false;
}

// Reports the current time to the watchdog, without feeding it.
void sim_watchdog_check(uint64_t now)
{
    if (running && now - fed > period)
        fired = true;
}

// Whether the watchdog has fired, because it was not fed in time.
bool sim_watchdog_fired(void)
{
    return fired;
}

// Periods are whole milliseconds.
SmResult pal_watchdog_start(uint64_t wanted, uint64_t *actual)
{
    SmResult r;

    if (!actual || wanted == 0 || wanted > LONGEST)
        return SM_E_ARGUMENT;
    r = running ? SM_E_BUSY : sim_begin_call(SIM_watchdog_start);
    if (r != SM_OK)
        return r;
    running = true;
    fed = pal_clock_now();
    *actual = period = (wanted + PAL_MILLISECOND - 1) / PAL_MILLISECOND * PAL_MILLISECOND;
    return SM_OK;
}

SmResult pal_watchdog_feed(void)
{
    SmResult r = running ? sim_begin_call(SIM_watchdog_feed) : SM_E_HANDLE;

    if (r == SM_OK)
        fed = pal_clock_now();
    return r;
}

SmResult pal_watchdog_stop(void)
{
    if (!running)
        return SM_E_HANDLE;
    running = false;
    return SM_OK;
}

SmResult pal_watchdog_caused_start(bool *caused)
{
    if (!caused)
        return SM_E_ARGUMENT;
    *caused = fired;
    return SM_OK;
}
