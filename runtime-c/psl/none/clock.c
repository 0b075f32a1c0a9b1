// SPDX-License-Identifier: Apache-2.0
// Platform without a clock: the time is always 0.
#include "runtime-c/pal/clock.h"

SmResult pal_clock_resolution(uint64_t *ns)
{
    (void)ns;
    return SM_E_UNSUPPORTED;
}

uint64_t pal_clock_now(void)
{
    return 0;
}

SmResult pal_clock_sleep_until(uint64_t time)
{
    (void)time;
    return SM_E_UNSUPPORTED;
}
