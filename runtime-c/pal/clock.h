// SPDX-License-Identifier: Apache-2.0
// The clock: nanoseconds since some moment before the program started.  It never goes back, is never set, and runs on at the same
// rate whatever happens to the time of day.  (Rules for all of these headers: pal.h.)
//
//     uint64_t tick;
//     if (pal_clock_resolution(&tick) != SM_OK)
//         refuse();                                      // at start; from here on the clock cannot fail
//     uint64_t next = pal_clock_now();
//     for (;;) {
//         step();
//         next += 10 * PAL_MILLISECOND;                  // absolute times do not drift, whatever a step takes
//         pal_clock_sleep_until(next);
//     }
#ifndef PAL_CLOCK_H
#define PAL_CLOCK_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

// The smallest difference that the clock can show, in nanoseconds, 1 or more.  SM_E_UNSUPPORTED: there is no clock.
SmResult pal_clock_resolution(uint64_t *ns);

// The time.  At least as large as any time it gave before, to any thread.  Takes no lock; may be called from anywhere, an interrupt
// as well.  Cannot fail where there is a clock; 0 where there is none.
uint64_t pal_clock_now(void);

// Waits until the clock shows `time` or more; returns at once if it already does.  Never returns earlier.  How much later
// is up to the scheduler: a thread with a real-time priority (thread.h) is woken first.
// SM_E_ARGUMENT: `time` is more than PAL_TIMEOUT_MAX ahead, which is a mistake in units more often than a wish.
SmResult pal_clock_sleep_until(uint64_t time);

#ifdef __cplusplus
}
#endif
#endif
