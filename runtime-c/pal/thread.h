// SPDX-License-Identifier: Apache-2.0
// Threads with priorities.  Of those that can run, the one with the highest real-time priority does, until it waits; among equals
// the first that was ready.  Threads without one (priority 0) share what is left.  A platform with one thread answers
// SM_E_UNSUPPORTED.  (Rules for all of these headers: pal.h.)
#ifndef PAL_THREAD_H
#define PAL_THREAD_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalThread { uint8_t id; } PalThread;

// What a thread runs.  It ends by returning; it should hold no lock then, for nobody could give it back.
typedef void PalThreadMain(void *argument);

#define PAL_PRIORITY_MAX 99

typedef struct PalThreadPlan {
    const char *name;         // for debuggers, which may show 15 bytes of it; NULL: none.  Not kept
    uint8_t priority;         // 0: not real-time; 1 … PAL_PRIORITY_MAX: the larger the more urgent
                              // (a platform with fewer levels keeps the order)
    uint32_t stack;           // bytes; 0: PAL_THREAD_STACK.  Rounded up to what the platform can do
} PalThreadPlan;

// Starts a thread that calls run(argument).  Where real-time priorities are not permitted the thread runs all the same,
// without: ask pal_thread_is_realtime.  Its stack is the platform's, taken here and given back by join.
// SM_E_ARGUMENT: priority above PAL_PRIORITY_MAX, a stack beyond what the platform can do.  SM_E_FULL.  SM_E_MEMORY: no room
// for the stack.
SmResult pal_thread_create(PalThread *thread, const PalThreadPlan *plan, PalThreadMain *run, void *argument);

// Waits until the thread has ended, then frees the handle.  What it wrote can be seen afterwards.  Every thread is to be
// joined, by one other.  SM_E_TIMEOUT: it still runs, the handle stays.  SM_E_BUSY: a thread cannot wait for itself, nor two
// for one.
SmResult pal_thread_join(PalThread thread, uint64_t timeout);

// Whether the thread has the real-time priority that its plan asked for.  False for priority 0 and for a handle that is not open.
bool pal_thread_is_realtime(PalThread thread);

// Gives the calling thread another priority (a program's first thread, for example).  SM_E_DENIED: not permitted; it stays as
// it was.
SmResult pal_thread_set_priority(uint8_t priority);

#ifdef __cplusplus
}
#endif
#endif
