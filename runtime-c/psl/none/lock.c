// SPDX-License-Identifier: Apache-2.0
// Platform without locks.
#include "runtime-c/pal/lock.h"

SmResult pal_lock_open(PalLock *lock)
{
    (void)lock;
    return SM_E_UNSUPPORTED;
}

SmResult pal_lock_close(PalLock lock)
{
    (void)lock;
    return SM_E_UNSUPPORTED;
}

SmResult pal_lock_take(PalLock lock, uint64_t timeout)
{
    (void)lock, (void)timeout;
    return SM_E_UNSUPPORTED;
}

SmResult pal_lock_give(PalLock lock)
{
    (void)lock;
    return SM_E_UNSUPPORTED;
}
