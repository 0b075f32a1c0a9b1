// SPDX-License-Identifier: Apache-2.0
// The system's calls come through the test first (ld's --wrap), so that each of them can be made to fail.
#ifndef PSL_OWN_FAULTS_LINUX_H
#define PSL_OWN_FAULTS_LINUX_H

#include <stdbool.h>

// Watches the calls from here on.  `left` of them still work (below 0: all), the next one fails with `error`; for_good: and all after it,
// as after a power failure.
void fault(int left, int error, bool for_good);
void no_fault(void);

// From now on each unlink and connect waits before and after the call, so that other programs get in between.  0: no longer.
void pause_calls(unsigned microseconds);

// The calls since then, a letter each: w write, f fsync, d fdatasync, r rename, u unlink, l waiting for a lock, t setting a timer, p ppoll,
// a accept4, m recvmsg, c connect.
const char *calls(void);

#endif
