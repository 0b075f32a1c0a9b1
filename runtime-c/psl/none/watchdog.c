// SPDX-License-Identifier: Apache-2.0
// Platform without a watchdog.
#include "runtime-c/pal/watchdog.h"

SmResult pal_watchdog_start(uint64_t period, uint64_t *actual)
{
    (void)period, (void)actual;
    return SM_E_UNSUPPORTED;
}

SmResult pal_watchdog_feed(void)
{
    return SM_E_UNSUPPORTED;
}

SmResult pal_watchdog_stop(void)
{
    return SM_E_UNSUPPORTED;
}

SmResult pal_watchdog_caused_start(bool *caused)
{
    (void)caused;
    return SM_E_UNSUPPORTED;
}
