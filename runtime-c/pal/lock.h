// SPDX-License-Identifier: Apache-2.0
// Mutual exclusion locks, for critical sections of a few memory accesses.  A thread that finds the lock held first retries a
// bounded number of times (PAL_LOCK_SPINS).  It then sleeps and lends its priority to the holder (priority inheritance).  An urgent
// thread therefore waits for one critical section, and not for threads of intermediate priority.  On bare metal a lock masks
// interrupts.
//
// Bare metal requires three things of the caller: keep critical sections short, do not wait inside them, and release locks in the
// reverse order of taking them.  (Rules for all of these headers: pal.h.)
#ifndef PAL_LOCK_H
#define PAL_LOCK_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalLock { uint8_t id; } PalLock;

// Creates a lock that is free.  SM_E_FULL: the table has no free entry.
SmResult pal_lock_open(PalLock *lock);

// Destroys a lock.  No other thread may be using the handle.  SM_E_BUSY: the lock is held.
SmResult pal_lock_close(PalLock lock);

// Takes the lock.  Any thread may call this with the same handle.  All writes by the previous holder are visible afterwards.
// SM_E_TIMEOUT: the lock was held for the whole timeout, or the thread that held it has ended.  The second case may return
// immediately.  SM_E_BUSY: the calling thread already holds the lock.
SmResult pal_lock_take(PalLock lock, uint64_t timeout);

// Releases the lock.  SM_E_BUSY: the calling thread does not hold it.
SmResult pal_lock_give(PalLock lock);

#ifdef __cplusplus
}
#endif
#endif
