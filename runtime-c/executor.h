// SPDX-License-Identifier: Apache-2.0
// An executor determines which tasks run when, and in which order.  It counts ticks of equal length from the start of the
// application.  At each tick, the rate groups that are due run in table order, and the tasks of a group run in table order.  The
// order is therefore the same in every run.
//
// Time is absolute: tick k is due k periods after the start, however long earlier ticks took.  The tasks receive this time.  At
// the start of a tick, element G is set to it, in G's unit and added to the value that G had at the start.  G never decreases.
//
// A tick that begins when the next one is already due is an overrun.  The tick runs.  The policy determines what happens to the
// ticks that are due by its end:
//   SM_SKIP       they are left out; the next tick is the next one in the future, so the phase is preserved
//   SM_CATCH_UP   they run one after the other without waiting; if there are more than `most`, the oldest are left out
// So the first tick always runs, however late, and every tick either runs or is left out: next = ticks + skipped.  Groups count
// ticks, not calls.  A group that is due every 10 ticks runs at ticks 0, 10, 20 … If one of these is left out, the group does not
// run before the next one.
//
// An overrun emits event OVERRUN, at most once a second, with the number of ticks left out since the previous OVERRUN.
#ifndef SM_EXECUTOR_H
#define SM_EXECUTOR_H

#include "runtime-c/pal/thread.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

// A rate group: tasks that run together at every `every`-th tick.
typedef struct SmRate {
    uint32_t every;           // number of ticks from one run of the group to the next
    uint16_t tasks;           // number of tasks; each task appears only once in an application
    SmTask *const *task;
} SmRate;

typedef enum SmOverrun { SM_SKIP, SM_CATCH_UP } SmOverrun;

// Elements that receive statistics of the executor at the end of each tick.  Any integer type (values saturate), or NULL.
typedef struct SmVitals {
    const SmElement *ticks;       // number of ticks run
    const SmElement *overruns;    // number of ticks that began when the next one was already due
    const SmElement *skipped;     // number of ticks left out
    const SmElement *late;        // delay of the start of the last tick, in microseconds
    const SmElement *busy;        // duration of the last tick, in microseconds
} SmVitals;

typedef struct SmExecutor {
    const char *name;
    uint64_t period;          // nanoseconds between ticks
    const SmRate *rate;
    uint16_t rates;
    uint8_t priority;         // priority of its thread (pal/thread.h); 0: not real-time
    SmOverrun overrun;
    uint32_t most;            // for SM_CATCH_UP: largest number of ticks to run late
    SmStateVec *sv;
    SmEvents *events;
    const SmElement *time;    // element G, a U64; or NULL
    uint64_t unit;            // nanoseconds per unit of G
    SmVitals vitals;
    uint16_t number;          // number of the executor in its application, from 0, for SmEvent.source
    // The fields below belong to the runtime; initially all zero.
    uint64_t start;           // PAL clock time at which tick 0 is due
    uint64_t base;            // value of G before the first tick
    uint64_t step;            // increment of G per tick; 0: the period is not a multiple of the unit
    uint64_t next;            // number of the next tick
    uint64_t ticks, overruns, skipped;
    uint64_t late, late_max, busy, busy_max;      // delay and duration of the last tick, and the greatest so far, in nanoseconds
    uint64_t ended;           // PAL clock time at which the last tick ended
    uint64_t reported_at, reported_skipped;       // time of the last OVERRUN event, and ticks reported so far
    // Used by the application that runs the executor (run.c).
    struct SmApp *app;
    PalThread thread;
    uint32_t next_shared;     // low 32 bits of `next`, for other threads
    uint32_t done;            // the executor's thread has ended
    uint64_t next_at_feed;    // value of `next` at the last watchdog feed
} SmExecutor;

// Checks the configuration, calls init of all tasks in order, and reads the starting value of G.  If a task's init fails, returns
// its result and does not initialise the tasks after it. *failed then points to the task (`failed` may be NULL).  Returns the
// result of sm_enter if G cannot be read.
// SM_E_ARGUMENT with *failed NULL means that the configuration is invalid:
// - there are no tasks to run;
// - a period, an `every` or a unit is 0;
// - an element does not belong to its state vector;
// - G is not a U64, or a statistic is not an integer.
SmResult sm_executor_init(SmExecutor *e, const SmTask **failed);

// Sets the PAL clock time at which tick 0 is due.
void sm_executor_start(SmExecutor *e, uint64_t at);

// Returns the PAL clock time at which the next tick is due.
uint64_t sm_executor_due(const SmExecutor *e);

// Runs the next tick immediately, and determines which tick follows it.
void sm_executor_tick(SmExecutor *e);

// Called after the last tick: puts all tasks into their safe state, in order (sm_task_safe).
void sm_executor_safe(SmExecutor *e);

#ifdef __cplusplus
}
#endif
#endif
