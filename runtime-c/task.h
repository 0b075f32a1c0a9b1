// SPDX-License-Identifier: Apache-2.0
// A task: a short piece of work that an executor calls again and again.  It reads and writes the state vector; what it keeps for itself
// is behind `context`.  A step waits for nothing and takes a bounded time.
//
// A U8 element may say how it runs, and anybody may change it at any time: SM_DISABLED nothing is called; SM_SAFED `safe` is called
// (nothing, where there is none): whatever brings a dangerous device to rest; SM_ENABLED `step` is called.  Any other value is taken
// for SM_SAFED.  A state vector that is all zero has its tasks disabled.  While the element cannot be read (statevec.h: a thread died
// inside a critical section) the task stays in the mode it had.
#ifndef SM_TASK_H
#define SM_TASK_H

#include <stdint.h>

#include "runtime-c/event.h"
#include "runtime-c/statevec.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmMode { SM_DISABLED = 0, SM_SAFED = 1, SM_ENABLED = 2 } SmMode;

// When a step runs.  All tasks of one tick are given the same.
typedef struct SmTick {
    uint64_t time;            // nanoseconds since the application started at which this tick was due: k times the executor's period
    uint64_t number;          // k
} SmTick;

typedef SmResult SmTaskInit(void *context);
typedef SmResult SmTaskStep(void *context, const SmTick *tick);

typedef struct SmTask {
    const char *name;
    SmTaskInit *init;         // once, before the first step of any task; or NULL.  What it refuses keeps the application from starting
    SmTaskStep *step;         // SM_OK, or why it failed: that is counted and told as an event, and the task is called again as ever
    SmTaskStep *safe;         // or NULL
    void *context;
    const SmElement *mode;    // of type U8; NULL: always enabled
    uint16_t number;          // of the task in its application: SmEvent.source
    // What follows is the runtime's; all zero at first.
    uint8_t last_mode;        // in which it ran last, or was left alone
    SmResult last;            // of the last call of step or safe
    uint32_t steps, safings, failures;        // how many calls of step, of safe, of both that failed; modulo 2^32
    uint32_t failing;         // failures in a row, up to UINT32_MAX
} SmTask;

// Calls init.  SM_E_ARGUMENT: there is no step, or `mode` is not a U8.
SmResult sm_task_init(SmTask *t);

// Runs it once, as its mode in sv says.  Event MODE when the mode has changed (before the first time it was SM_DISABLED); event FAULT
// when failing begins and when it ends, not in between.
void sm_task_run(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick);

// The end of the application: `safe` is called once, whatever the mode but SM_DISABLED.
void sm_task_rest(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick);

#ifdef __cplusplus
}
#endif
#endif
