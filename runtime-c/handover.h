// SPDX-License-Identifier: Apache-2.0
// Internal to log and keep: passes data from a task's step to a thread without a deadline.  A lock protects the few counters that
// both use.  A platform without locks has no threads either, and then no lock is taken.
#ifndef SM_HANDOVER_H
#define SM_HANDOVER_H

#include "runtime-c/pal/lock.h"

// Opens the lock, unless it is open. Without locks on this platform, its number stays 0.
static inline SmResult sm_handover_open(PalLock *lock)
{
    SmResult r = lock->id != 0 ? SM_OK : pal_lock_open(lock);

    if (r == SM_E_UNSUPPORTED)
        lock->id = 0;
    return r == SM_E_UNSUPPORTED ? SM_OK : r;
}

static inline SmResult sm_handover_lock(PalLock lock)
{
    return lock.id != 0 ? pal_lock_take(lock, SM_LOCK_WAIT) : SM_OK;
}

static inline void sm_handover_unlock(PalLock lock)
{
    if (lock.id != 0)
        (void)pal_lock_give(lock);
}

#endif
