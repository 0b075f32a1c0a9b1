// SPDX-License-Identifier: Apache-2.0
// The simulated platform as a whole: reset and fault injection.
#include <string.h>

#include "runtime-c/psl/sim/world.h"

static struct {
    uint32_t count, after;    // number of calls so far; number of calls that still succeed before the fault
    uint64_t delay;
    SmResult result;          // result of the injected fault; SM_OK: no call fails
    bool permanent;           // all calls after the fault fail too
} calls[SIM_CALLS];

// Restores the state of program start: time at 1 s, nothing open, pins low, no faults, memories and logs erased.
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

// After `after` more calls of this kind, one call fails with `result`; with `permanent`, all later ones too.
static void plan_fault(SimCall call, uint32_t after, SmResult result, bool permanent)
{
    calls[call].after = after;
    calls[call].result = result;
    calls[call].permanent = permanent;
}

// After `after` more calls of that kind, one call fails with `result` and does nothing.
void sim_fail(SimCall call, uint32_t after, SmResult result)
{
    plan_fault(call, after, result, false);
}

// Like sim_fail, but all later calls fail too: the device is broken.
void sim_break(SimCall call, uint32_t after, SmResult result)
{
    plan_fault(call, after, result, true);
}

// From now on each call of that kind takes `ns` nanoseconds.
void sim_delay(SimCall call, uint64_t ns)
{
    calls[call].delay = ns;
}

// Returns the number of calls of that kind since sim_reset.
uint32_t sim_count(SimCall call)
{
    return calls[call].count;
}

// Counts a call, advances time by its delay (sim_delay), and returns the error that was set with sim_fail or sim_break.
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
