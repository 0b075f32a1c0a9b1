// SPDX-License-Identifier: Apache-2.0
// Threads with priorities.  Of the ready threads, the one with the highest real-time priority runs until it waits.  Threads of
// equal priority run in the order in which they became ready.  Threads without a real-time priority (priority 0) share the
// remaining time.  A platform with only one thread returns SM_E_UNSUPPORTED.  (Rules for all of these headers: pal.h.)
#ifndef PAL_THREAD_H
#define PAL_THREAD_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalThread { uint8_t id; } PalThread;

// The main function of a thread.  The thread ends when it returns.  It must not hold a lock then, because no other thread can
// release it.
typedef void PalThreadMain(void *argument);

#define PAL_PRIORITY_MAX 99

typedef struct PalThreadPlan {
    const char *name;         // for debuggers, which may show 15 bytes of it; NULL: none.  Used during the call only
    uint8_t priority;         // 0: not real-time; 1 … PAL_PRIORITY_MAX: higher values are more urgent
                              // (a platform with fewer levels preserves the order)
    uint32_t stack;           // stack size in bytes; 0: PAL_THREAD_STACK.  Rounded up to a size that the platform supports
} PalThreadPlan;

// Starts a thread that calls run(argument).  If real-time priorities are not permitted, the thread runs without one; see
// pal_thread_is_realtime.  The platform allocates the stack here and frees it in pal_thread_join.
// SM_E_ARGUMENT: `priority` exceeds PAL_PRIORITY_MAX, or the platform does not support the stack size.  SM_E_FULL: the table has no
// free entry.  SM_E_MEMORY: no memory for the stack.
SmResult pal_thread_create(PalThread *thread, const PalThreadPlan *plan, PalThreadMain *run, void *argument);

// Waits until the thread has ended, then frees the handle.  Everything that the thread wrote is visible afterwards.  Every thread
// must be joined by exactly one other thread.  SM_E_TIMEOUT: the thread still runs, and the handle stays valid.  SM_E_BUSY: the
// thread is the caller itself, or another thread is already waiting for it.
SmResult pal_thread_join(PalThread thread, uint64_t timeout);

// Whether the thread has the real-time priority that its plan requested.  False for priority 0 and for a handle that is not open.
bool pal_thread_is_realtime(PalThread thread);

// Changes the priority of the calling thread, for example of a program's first thread.  SM_E_DENIED: not permitted; the priority
// does not change.
SmResult pal_thread_set_priority(uint8_t priority);

#ifdef __cplusplus
}
#endif
#endif
