// SPDX-License-Identifier: Apache-2.0
// The clock: nanoseconds since an arbitrary time before the program started.  It is monotonic.  It is never set, and changes to the
// time of day do not affect its rate.  (Rules for all of these headers: pal.h.)
//
//     uint64_t tick;
//     if (pal_clock_resolution(&tick) != SM_OK)
//         refuse();                                      // at start; afterwards the clock cannot fail
//     uint64_t next = pal_clock_now();
//     for (;;) {
//         step();
//         next += 10 * PAL_MILLISECOND;                  // absolute times do not drift, however long a step takes
//         pal_clock_sleep_until(next);
//     }
#ifndef PAL_CLOCK_H
#define PAL_CLOCK_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

// Stores the resolution of the clock in *ns, in nanoseconds, 1 or more.  SM_E_UNSUPPORTED: there is no clock.
SmResult pal_clock_resolution(uint64_t *ns);

// Returns the time in nanoseconds, never less than any value that it returned before, to any thread.  It takes no lock and may be
// called from any context, including interrupts.  It cannot fail; on a platform without a clock it returns 0.
uint64_t pal_clock_now(void);

// Waits until the clock shows `time` or later.  Returns immediately if it already does, and never returns earlier.  The scheduler
// determines the delay after `time`; a thread with a real-time priority (thread.h) wakes first.
// SM_E_ARGUMENT: `time` is more than PAL_TIMEOUT_MAX ahead, which usually means a mistake in units.
SmResult pal_clock_sleep_until(uint64_t time);

#ifdef __cplusplus
}
#endif
#endif
