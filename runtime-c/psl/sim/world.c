// SPDX-License-Identifier: Apache-2.0
// The simulated platform as a whole: reset and fault injection.
#include <string.h>

#include "runtime-c/psl/sim/world.h"

static struct {
    uint32_t count, after;    // calls so far; calls that still succeed before the fault
    uint64_t delay;
    SmResult result;          // result of the injected fault; SM_OK: no call fails
    bool permanent;           // all calls after the fault fail too
} calls[SIM_CALLS];

void sim_reset(void)
{
    memset(calls, 0, sizeof calls);
    sim_clock_reset();
    sim_console_reset();
    sim_lock_reset();
    sim_dio_reset();
    sim_aio_reset();
    sim_serial_reset();
    sim_socket_reset();
    sim_nvm_reset();
    sim_log_reset();
    sim_watchdog_reset();
}

static void plan_fault(SimCall call, uint32_t after, SmResult result, bool permanent)
{
    calls[call].after = after;
    calls[call].result = result;
    calls[call].permanent = permanent;
}

void sim_fail(SimCall call, uint32_t after, SmResult result)
{
    plan_fault(call, after, result, false);
}

void sim_break(SimCall call, uint32_t after, SmResult result)
{
    plan_fault(call, after, result, true);
}

void sim_delay(SimCall call, uint64_t ns)
{
    calls[call].delay = ns;
}

uint32_t sim_count(SimCall call)
{
    return calls[call].count;
}

SmResult sim_begin_call(SimCall call)
{
    SmResult r = calls[call].result;

    calls[call].count++;
    sim_advance(calls[call].delay);
    if (r == SM_OK || calls[call].after > 0) {
        calls[call].after -= r != SM_OK;
        return SM_OK;
    }
    if (!calls[call].permanent)
        calls[call].result = SM_OK;
    return r;
}
