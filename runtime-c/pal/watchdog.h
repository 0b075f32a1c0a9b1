// SPDX-License-Identifier: Apache-2.0
// The watchdog: starts the computer, or where there is no hardware for that the program, anew when nobody feeds it for some
// time.  There is one, it has no handle.  (Rules for all of these headers: pal.h.)
#ifndef PAL_WATCHDOG_H
#define PAL_WATCHDOG_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

// Starts it: from now on it must be fed at least every `period` nanoseconds.  The platform takes the shortest period that it
// has and that is not shorter; *actual says which.  SM_E_ARGUMENT: 0, or longer than any it has.  SM_E_BUSY: it runs already.
// SM_E_MISSING: this computer has none.  SM_E_DENIED: not permitted.
SmResult pal_watchdog_start(uint64_t period, uint64_t *actual);

// Feeds it.  SM_E_HANDLE: it is not running.
SmResult pal_watchdog_feed(void);

// Stops it.  SM_E_DENIED: it cannot be stopped, and runs on.  SM_E_HANDLE: it is not running.
SmResult pal_watchdog_stop(void);

// Whether it was the watchdog that started the computer or the program this time.  SM_E_UNSUPPORTED: nobody can tell.
SmResult pal_watchdog_bit(bool *bit);

#ifdef __cplusplus
}
#endif
#endif
