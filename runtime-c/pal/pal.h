// SPDX-License-Identifier: Apache-2.0
// The platform abstraction layer (PAL): everything that the runtime needs from a computer.  These headers declare the functions and
// define their behaviour.  A platform support layer (../psl/NAME) implements them with one file for each header.  The platform is
// chosen at link time.  The following rules apply to all headers of this folder.
//
// Results     Every call that can fail returns an SmResult: SM_OK or the reason for the failure.  Unless its description says
//             otherwise, a call that fails changes nothing and fills in nothing.  SM_E_UNSUPPORTED: the platform does not have this
//             feature and never will.  SM_E_ARGUMENT: a pointer is null or a number is out of range.  SM_E_DEVICE: the operating
//             system or the hardware failed for a reason without a code here; a retry may succeed.
// Handles     Small structs with a number, which may be copied.  The number identifies an entry in a static table of the platform.
//             {0} is never a valid handle.  SM_E_FULL: the table has no free entry (sizes: config.h).  SM_E_HANDLE: the handle
//             was never opened, or is closed.  Numbers are reused after a close, so keep no copies of a closed handle.
// Memory      No call allocates from a heap.  Unless its description says otherwise, a call reads or fills memory that the caller
//             passes only during the call, and keeps no pointer to it.
// Time        Nanoseconds as uint64_t, of the one clock in clock.h.  A timeout counts from the call; 0 does not wait.  The longest
//             timeout is PAL_TIMEOUT_MAX.  Longer ones return SM_E_ARGUMENT, so no call waits forever.  A call returns at its
//             timeout or later, depending on the scheduler.  A call without a timeout does not wait for anything outside the
//             computer, unless its header says how long it may take.
// Threads     Any call may be made from any thread, but not from an interrupt.  Only one thread at a time may use a handle, unless
//             its header allows more.
// Start-up    Open everything at start, when a failure can still be shown to the user.  Afterwards, calls fail only for external
//             reasons.
#ifndef PAL_H
#define PAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "runtime-c/pal/config.h"
#include "stdlib/result.h"

#define PAL_MICROSECOND 1000u
#define PAL_MILLISECOND 1000000u
#define PAL_SECOND      1000000000u
#define PAL_TIMEOUT_MAX ((uint64_t)3600 * PAL_SECOND)   // one hour

#endif
