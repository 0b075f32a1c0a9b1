// SPDX-License-Identifier: Apache-2.0
// An executor: which tasks run when, in which order.  It counts ticks of one length from the application's start.  At each tick the rate
// groups that are due run in the order in which they stand, and in a group the tasks in theirs: the order is the same in every run.
//
// Time is absolute: tick k is due at k times the period, whatever the ticks before it took.  At the start of a tick, element G is set
// to that time in its unit, never backwards.  A tick that begins when the next is due already is an overrun:
//   SM_SKIP       ticks that have been missed are left out; the next is the next that is still to come (the phase stays)
//   SM_CATCH_UP   they are run, one after the other without waiting, up to `most` of them; what is beyond that is left out
// Groups count ticks, not calls: one that is due every 10 ticks runs at ticks 0, 10, 20 …, and if one of these is left out, not before the next.
#ifndef SM_EXECUTOR_H
#define SM_EXECUTOR_H

#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmRate {
    uint32_t every;           // ticks
    uint16_t tasks;
    SmTask *const *task;
} SmRate;

typedef enum SmOverrun { SM_SKIP, SM_CATCH_UP } SmOverrun;

// Where an executor tells how it is doing: elements of any integer type (they saturate), or NULL.
typedef struct SmVitals {
    const SmElement *ticks;       // that ran
    const SmElement *overruns;    // ticks that began when the next was already due
    const SmElement *skipped;     // ticks left out
    const SmElement *late;        // microseconds that the last tick began too late
    const SmElement *busy;        // microseconds that the last tick took
} SmVitals;

typedef struct SmExecutor {
    const char *name;
    uint64_t period;          // nanoseconds between ticks
    const SmRate *rate;
    uint16_t rates;
    uint8_t priority;         // of its thread (pal/thread.h); 0: not real-time
    SmOverrun overrun;
    uint32_t most;            // SM_CATCH_UP
    SmStateVec *sv;
    SmEvents *events;
    const SmElement *time;    // G, a U64; or NULL
    uint64_t unit;            // nanoseconds of 1 in G
    SmVitals vitals;
    uint16_t number;          // of the executor in its application: SmEvent.source
    // What follows is the runtime's; all zero at first.
    uint64_t start;           // on the PAL clock: when tick 0 is due
    uint64_t base;            // G at the start
    uint64_t next;            // the number of the next tick
    uint64_t ticks, overruns, skipped;
    uint64_t late, late_most, busy, busy_most;    // nanoseconds
    uint32_t alive;           // changes with every tick: for the watchdog
} SmExecutor;

// Checks the plan and calls init of all tasks, in order.  *failed, where it is not NULL, is then the task that refused.
SmResult sm_executor_init(SmExecutor *e, const SmTask **failed);

// Sets when tick 0 is due.
void sm_executor_start(SmExecutor *e, uint64_t at);

// When the next tick is due, on the PAL clock.
uint64_t sm_executor_due(const SmExecutor *e);

// Runs the next tick, now, and decides which one comes after it.
void sm_executor_tick(SmExecutor *e);

#ifdef __cplusplus
}
#endif
#endif
