// SPDX-License-Identifier: Apache-2.0
// Simulated locks.  There is only one thread, so a held lock is always held by the caller.
#include <string.h>

#include "runtime-c/pal/lock.h"
#include "runtime-c/psl/sim/world.h"

static bool used[PAL_LOCKS], held[PAL_LOCKS];

void sim_lock_reset(void)
{
    memset(used, 0, sizeof used);
    memset(held, 0, sizeof held);
}

SmResult pal_lock_open(PalLock *lock)
{
    uint8_t id;

    if (!lock)
        return SM_E_ARGUMENT;
    id = psl_table_allocate(used, PAL_LOCKS);
    if (id == 0)
        return SM_E_FULL;
    held[id - 1] = false;
    lock->id = id;
    return SM_OK;
}

SmResult pal_lock_close(PalLock lock)
{
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    if (held[lock.id - 1])
        return SM_E_BUSY;
    used[lock.id - 1] = false;
    return SM_OK;
}

// Returns SM_E_TIMEOUT only if a test requests it with sim_fail.
SmResult pal_lock_take(PalLock lock, uint64_t timeout)
{
    SmResult r;

    if (timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    r = held[lock.id - 1] ? SM_E_BUSY : sim_begin_call(SIM_lock_take);
    if (r == SM_OK)
        held[lock.id - 1] = true;
    return r;
}

SmResult pal_lock_give(PalLock lock)
{
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    if (!held[lock.id - 1])
        return SM_E_BUSY;
    held[lock.id - 1] = false;
    return SM_OK;
}
