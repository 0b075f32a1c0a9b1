// SPDX-License-Identifier: Apache-2.0
// The clock: CLOCK_MONOTONIC, which ignores changes of the time of day.  A time server adjusts its rate by at most 500 ppm.  It
// stops while the computer is suspended.
#define _GNU_SOURCE
#include <errno.h>

#include "runtime-c/psl/linux/linux.h"

static uint64_t to_nanoseconds(struct timespec t)
{
    return (uint64_t)t.tv_sec * PAL_SECOND + (uint64_t)t.tv_nsec;
}

SmResult pal_clock_resolution(uint64_t *ns)
{
    struct timespec t;

    if (!ns)
        return SM_E_ARGUMENT;
    if (clock_getres(CLOCK_MONOTONIC, &t) != 0)
        return SM_E_UNSUPPORTED;
    *ns = to_nanoseconds(t) > 0 ? to_nanoseconds(t) : 1;
    return SM_OK;
}

uint64_t pal_clock_now(void)
{
    struct timespec t = {0, 0};

    clock_gettime(CLOCK_MONOTONIC, &t);
    return to_nanoseconds(t);
}

SmResult pal_clock_sleep_until(uint64_t time)
{
    struct timespec t = psl_timespec(time);
    uint64_t now = pal_clock_now();
    int error;

    if (time > now && time - now > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    do
        error = clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL);
    while (error == EINTR);
    return error == 0 ? SM_OK : SM_E_DEVICE;
}
