// SPDX-License-Identifier: Apache-2.0
// The watchdog without hardware: a kernel timer that kills the program (SIGKILL, which cannot be blocked).  The program's
// supervisor must restart it: systemd, a shell loop.  It does not protect against a kernel that hangs.
#define _GNU_SOURCE
#include <errno.h>
#include <signal.h>
#include <string.h>

#include "runtime-c/pal/watchdog.h"
#include "runtime-c/psl/linux/linux.h"

static bool running;
static timer_t timer;
static uint64_t period;

static SmResult set_timer(uint64_t ns)
{
    struct itimerspec t;

    memset(&t, 0, sizeof t);
    t.it_value = psl_timespec(ns);
    return timer_settime(timer, 0, &t, NULL) == 0 ? SM_OK : psl_result_of_errno(errno);
}

SmResult pal_watchdog_start(uint64_t wanted, uint64_t *actual)
{
    struct sigevent event;
    SmResult r;

    if (!actual || wanted == 0 || wanted > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (running)
        return SM_E_BUSY;
    memset(&event, 0, sizeof event);
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGKILL;
    if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0)
        return psl_result_of_errno(errno);
    r = set_timer(wanted);
    running = r == SM_OK;
    if (running)
        *actual = period = wanted;
    else
        timer_delete(timer);
    return r;
}

SmResult pal_watchdog_feed(void)
{
    return running ? set_timer(period) : SM_E_HANDLE;
}

SmResult pal_watchdog_stop(void)
{
    if (!running)
        return SM_E_HANDLE;
    timer_delete(timer);
    running = false;
    return SM_OK;
}

SmResult pal_watchdog_caused_start(bool *caused)
{
    return caused ? SM_E_UNSUPPORTED : SM_E_ARGUMENT;
}
