// SPDX-License-Identifier: Apache-2.0
// An executor: which tasks run when, in which order.  It counts ticks of one length from the application's start.  At each tick the rate
// groups that are due run in the order in which they stand, and in a group the tasks in theirs: the order is the same in every run.
//
// Time is absolute: tick k is due at k times the period after the start, whatever the ticks before it took, and that is the time that its
// tasks are given.  At the start of a tick element G is set to it, in G's unit, counted from what G held at the start; never backwards.
//
// A tick that begins when the next is due already is an overrun.  It runs; those due by its end have been missed:
//   SM_SKIP       they are left out; the next is the next that is still to come (the phase stays)
//   SM_CATCH_UP   they are run, one after the other without waiting; of more than `most` the oldest are left out
// So the first tick always runs, however late, and every tick is either run or left out: next = ticks + skipped.  Groups count
// ticks, not calls: one that is due every 10 ticks runs at ticks 0, 10, 20 …, and if one of these is left out, not before the next.
//
// Event OVERRUN at an overrun, but one a second at most: what was left out since the one before.
#ifndef SM_EXECUTOR_H
#define SM_EXECUTOR_H

#include "runtime-c/pal/thread.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmRate {
    uint32_t every;           // ticks
    uint16_t tasks;           // a task stands once in an application
    SmTask *const *task;
} SmRate;

typedef enum SmOverrun { SM_SKIP, SM_CATCH_UP } SmOverrun;

// Where an executor tells how it is doing, at the end of each tick: elements of any integer type (they saturate), or NULL.
typedef struct SmVitals {
    const SmElement *ticks;       // that ran
    const SmElement *overruns;    // ticks that began when the next was due already
    const SmElement *skipped;     // ticks left out
    const SmElement *late;        // microseconds that the last tick began too late
    const SmElement *busy;        // microseconds that the last tick took, from its beginning to its end
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
    uint64_t base;            // G before the first tick
    uint64_t step;            // of G from tick to tick; 0: the period is no multiple of the unit
    uint64_t next;            // the number of the next tick
    uint64_t ticks, overruns, skipped;
    uint64_t late, late_most, busy, busy_most;    // nanoseconds
    uint64_t ended;           // on the PAL clock: when the last tick ended
    uint64_t told, told_skipped;                  // time of the last event OVERRUN, and what has been told
    // Of the application that runs it (run.c).
    struct SmApp *app;
    PalThread thread;
    uint32_t alive;           // the lower half of `next`, for other threads
    uint32_t done;            // its thread has come to its end
    uint64_t seen;            // `next` when the watchdog was fed last
} SmExecutor;

// Checks the plan, then calls init of all tasks, in order, and reads G, which goes on from there.  Where a task refuses, its result, and the
// task in *failed (if failed is not NULL); those after it are not called.  The result of sm_enter where G cannot be read.  SM_E_ARGUMENT without a task: the plan is wrong (nothing to run, a period, an `every` or a unit
// of 0, elements that are not of its state vector, G that is not a U64, vitals that are not integers).
SmResult sm_executor_init(SmExecutor *e, const SmTask **failed);

// Sets when tick 0 is due.
void sm_executor_start(SmExecutor *e, uint64_t at);

// When the next tick is due, on the PAL clock.
uint64_t sm_executor_due(const SmExecutor *e);

// Runs the next tick, now, and decides which one comes after it.
void sm_executor_tick(SmExecutor *e);

// When no tick comes any more: brings all its tasks to rest, in order (sm_task_rest).
void sm_executor_rest(SmExecutor *e);

#ifdef __cplusplus
}
#endif
#endif
