// SPDX-License-Identifier: Apache-2.0
// Locks: one thread at a time.  Made for critical sections of a few memory accesses: a taker first tries a bounded number of times
// (PAL_LOCK_SPINS), then sleeps and lends its priority to the holder, so that an urgent thread waits for one critical
// section and not for whoever is in between (priority inheritance).  On bare metal a lock masks interrupts.
//
// For the sake of bare metal: keep what is done under a lock short, wait for nothing there, and give locks back in the
// opposite order of taking them.  (Rules for all of these headers: pal.h.)
#ifndef PAL_LOCK_H
#define PAL_LOCK_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalLock { uint8_t id; } PalLock;

// A new lock that nobody holds.  SM_E_FULL.
SmResult pal_lock_open(PalLock *lock);

// Frees it.  SM_E_BUSY: somebody holds it.  No other thread may be using the handle.
SmResult pal_lock_close(PalLock lock);

// Takes it; any thread may, with the same handle.  Everything that the last holder wrote can be seen.
// SM_E_TIMEOUT: it was held all the time, or its holder's thread has ended, which may be told at once.  SM_E_BUSY: the caller itself holds it already.
SmResult pal_lock_take(PalLock lock, uint64_t timeout);

// Gives it back.  SM_E_BUSY: the caller does not hold it.
SmResult pal_lock_give(PalLock lock);

#ifdef __cplusplus
}
#endif
#endif
