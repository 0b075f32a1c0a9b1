// SPDX-License-Identifier: Apache-2.0
// ld's --wrap replaces system calls by those of the test, so that each of them can be made to fail.
#ifndef PSL_OWN_FAULTS_LINUX_H
#define PSL_OWN_FAULTS_LINUX_H

#include <stdbool.h>

// Checks the calls from here on.  `left` of them still succeed (below 0: all), the next one fails with `error`.  With for_good, all later ones
// fail, too, as after a power failure.
void fault(int left, int error, bool for_good);
void no_fault(void);

// From now on each unlink and connect waits before and after the call, so that other programs run in between.  0: no wait.
void pause_calls(unsigned microseconds);

// Returns the calls since then, one letter each: w write, f fsync, d fdatasync, r rename, u unlink, l waiting for a lock, t setting a timer, p
// ppoll, a accept4, m recvmsg, c connect.
const char *calls(void);

#endif
