// SPDX-License-Identifier: Apache-2.0
// The simulated clock: the time advances only in a sleep, in a wait, or when a test advances it.
#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/world.h"

static uint64_t now = PAL_SECOND, late;         // late: how much each sleep exceeds its end (sim_oversleep)

static struct {
    void (*step)(void);       // the function of sim_every; or NULL
    uint64_t period, next;
} world;

void sim_clock_reset(void)
{
    now = PAL_SECOND;
    late = 0;
    world.step = NULL;
}

// From now on `step` simulates the external world every `period` nanoseconds, whatever advances the time; period 0: never.
void sim_every(uint64_t period, void (*step)(void))
{
    world.step = period > 0 ? step : NULL;
    world.period = period;
    world.next = now + period;
}

// Advances the time by `ns` nanoseconds, and runs the external world (sim_every) at each of its times.
void sim_advance(uint64_t ns)
{
    uint64_t end = now + ns;

    while (world.step && world.next <= end) {
        now = world.next;
        world.next += world.period;
        sim_watchdog_check(now);
        world.step();
    }
    now = end;
    sim_watchdog_check(now);
}

// Advances time to `time`, if that is in the future.
void sim_advance_to(uint64_t time)
{
    if (time > now)
        sim_advance(time - now);
}

// Advances the time to `end`, but only to the next action of the external world (sim_every) if that is earlier.
bool sim_wait(uint64_t end)
{
    if (now >= end)
        return false;
    sim_advance_to(world.step && world.next < end ? world.next : end);
    return true;
}

// From now on each sleep ends `ns` nanoseconds late.
void sim_oversleep(uint64_t ns)
{
    late = ns;
}

SmResult pal_clock_resolution(uint64_t *ns)
{
    if (!ns)
        return SM_E_ARGUMENT;
    *ns = 1;
    return SM_OK;
}

uint64_t pal_clock_now(void)
{
    return now;
}

SmResult pal_clock_sleep_until(uint64_t time)
{
    SmResult r;

    if (time > now && time - now > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_clock_sleep_until);
    if (r == SM_OK && time > now)
        sim_advance_to(time + late);
    return r;
}
