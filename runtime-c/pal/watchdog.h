// SPDX-License-Identifier: Apache-2.0
// The watchdog: restarts the computer if it is not fed in time.  Without watchdog hardware it restarts the program.  There is one
// watchdog, so it has no handle.  (Rules for all of these headers: pal.h.)
#ifndef PAL_WATCHDOG_H
#define PAL_WATCHDOG_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

// Starts the watchdog.  From now on it must be fed at least every `period` nanoseconds.  The platform chooses the shortest period
// that it supports and that is not below `period`, and stores it in *actual.
//     SM_E_ARGUMENT      `period` is 0, or longer than any supported period
//     SM_E_BUSY          it is already running
//     SM_E_MISSING       this computer has no watchdog
//     SM_E_DENIED        no permission
SmResult pal_watchdog_start(uint64_t period, uint64_t *actual);

// Feeds the watchdog.  SM_E_HANDLE: it is not running.
SmResult pal_watchdog_feed(void);

// Stops the watchdog.  SM_E_DENIED: it cannot be stopped and keeps running.  SM_E_HANDLE: it is not running.
SmResult pal_watchdog_stop(void);

// Whether the watchdog caused this start of the computer or program.  SM_E_UNSUPPORTED: the platform cannot determine this.
SmResult pal_watchdog_caused_start(bool *caused);

#ifdef __cplusplus
}
#endif
#endif
