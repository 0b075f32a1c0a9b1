// SPDX-License-Identifier: Apache-2.0
// The platform abstraction layer: all that the runtime asks of a computer.  These headers are prototypes and promises; a
// platform support layer (../psl/NAME) holds them, one file a header, and is chosen when linking.  What follows holds for all:
//
// Results     Every call that can fail gives an SmResult: SM_OK, or why not.  A call that fails has changed nothing and filled in
//             nothing, unless its sentence says so.  SM_E_UNSUPPORTED: this platform has no such thing; it will not have it later
//             either.  SM_E_ARGUMENT: a pointer is null, a number out of range.  SM_E_DEVICE: the system or the hardware says no
//             for a reason that has no number of its own; trying again may help.
// Handles     Small structs with a number, copied freely, that stand for an entry in a static table of the platform.
//             {0} is never a valid one.  SM_E_FULL: the table has no entry left (sizes: ../config.h).  SM_E_HANDLE: the handle
//             was never opened or is closed.  A number may be given out again after its close: keep no copies.
// Memory      Nothing allocates from a heap.  Memory that is passed in is read or filled during the call and not kept, unless
//             the sentence says so.
// Time        Nanoseconds as uint64_t, of the one clock in clock.h.  A timeout counts from the call; 0 does not wait at all.
//             The longest is PAL_TIMEOUT_MAX, beyond it SM_E_ARGUMENT: no call waits for ever.  A call returns at its timeout or
//             later, as the scheduler lets it.  A call without a timeout does not wait for anything outside the computer, unless
//             its header says how long it may take.
// Threads     Any call may be made from any thread, but not from an interrupt.  One handle is for one thread at a time,
//             unless its header says more.
// Start-up    Open everything at start, where a refusal can still be shown to somebody.  Afterwards calls fail only
//             because something outside does.
#ifndef PAL_H
#define PAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "runtime-c/config.h"
#include "stdlib/result.h"

#define PAL_MICROSECOND 1000u
#define PAL_MILLISECOND 1000000u
#define PAL_SECOND      1000000000u
#define PAL_TIMEOUT_MAX ((uint64_t)3600 * PAL_SECOND)   // an hour

#endif
