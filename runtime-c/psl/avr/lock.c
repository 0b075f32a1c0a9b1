// SPDX-License-Identifier: Apache-2.0
// Locks mask interrupts.  They are released in the reverse order of taking, so only the first one saves the interrupt flag.
#include "runtime-c/pal/lock.h"

#include "runtime-c/psl/avr/avr.h"
#include "runtime-c/psl/table.h"

#ifdef PSL_AVR

static bool used[PAL_LOCKS], held[PAL_LOCKS];
static uint8_t depth, interrupt_flag;  // number of held locks; the interrupt flag before the first of them

SmResult pal_lock_open(PalLock *lock)
{
    if (!lock)
        return SM_E_ARGUMENT;
    lock->id = psl_table_allocate(used, PAL_LOCKS);
    return lock->id == 0 ? SM_E_FULL : SM_OK;
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

SmResult pal_lock_take(PalLock lock, uint64_t timeout)
{
    const uint8_t flags = SREG;

    if (timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    if (held[lock.id - 1])
        return SM_E_BUSY;
    cli();
    if (depth++ == 0)
        interrupt_flag = flags;
    held[lock.id - 1] = true;
    return SM_OK;
}

SmResult pal_lock_give(PalLock lock)
{
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    if (!held[lock.id - 1])
        return SM_E_BUSY;
    held[lock.id - 1] = false;
    if (--depth == 0)
        SREG = interrupt_flag;
    return SM_OK;
}

#endif
