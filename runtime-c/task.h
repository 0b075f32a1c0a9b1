// SPDX-License-Identifier: Apache-2.0
// A task: a short piece of work that an executor calls repeatedly.  It reads and writes the state vector.  `context` points to its
// private data.  A step never waits and takes a bounded time.
//
// A U8 element may select the mode of a task.  Any task or thread may change it at any time:
//   SM_DISABLED   nothing is called
//   SM_SAFED      `safe` is called, if there is one; it puts a dangerous device into a safe state
//   SM_ENABLED    `step` is called
// Any other value is treated as SM_SAFED.  In a state vector that is all zero, tasks are disabled.  If the element cannot be read
// (statevec.h: a thread died inside a critical section), the task stays in its previous mode.
#ifndef SM_TASK_H
#define SM_TASK_H

#include <stdint.h>

#include "runtime-c/event.h"
#include "runtime-c/statevec.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmMode { SM_DISABLED = 0, SM_SAFED = 1, SM_ENABLED = 2 } SmMode;

// The time at which a step runs.  All tasks of a tick receive the same value.
typedef struct SmTick {
    uint64_t time;            // due time of this tick in nanoseconds since the start of the application: k times the executor's period
    uint64_t number;          // k, the number of the tick, from 0
} SmTick;

typedef SmResult SmTaskInit(void *context);
typedef SmResult SmTaskStep(void *context, const SmTick *tick);

typedef struct SmTask {
    const char *name;
    SmTaskInit *init;         // called once, before the first step of any task; or NULL.  If it fails, the application does not start
    SmTaskStep *step;         // SM_OK or an error, which is counted and emitted as an event; the task is called again regardless
    SmTaskStep *safe;         // called instead of `step` in mode SM_SAFED; or NULL
    void *context;
    const SmElement *mode;    // element of type U8 that selects the mode; NULL: always enabled
    uint16_t number;          // number of the task in its application, for SmEvent.source
    // The fields below belong to the runtime; initially all zero.
    uint8_t last_mode;        // mode at its last tick
    SmResult last_result;     // result of the last call of step or safe
    uint32_t steps, safings, failures;        // number of calls of step, of safe, and of failed calls of both; modulo 2^32
    uint32_t failures_in_row; // consecutive failures, at most UINT32_MAX
} SmTask;

// Calls init.  SM_E_ARGUMENT: `step` is NULL, or `mode` is not a U8.
SmResult sm_task_init(SmTask *t);

// Runs the task once in the mode selected in sv.  Emits event MODE if the mode has changed (its value before the first tick is
// SM_DISABLED).  Emits event FAULT when failures begin, even a single one, and at the next success.
void sm_task_run(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick);

// Called at the end of the application: calls `safe` once, unless the task is disabled.
void sm_task_safe(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick);

#ifdef __cplusplus
}
#endif
#endif
