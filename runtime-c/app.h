// SPDX-License-Identifier: Apache-2.0
// A whole application: its state vector, its executors with their tasks, what is kept and logged.  Made by smc from a .app file
// (docs/config.md), with a main that is one call: sm_app_main(&rocket_app).
//
// Start, in this order: the state vector's lock; the values of [start]; the kept vector, where there is one; init of all tasks, executor by
// executor; the watchdog; tick 0.  What is refused on the way is told on the console, and nothing runs.
//
// Each executor has a thread, where the platform has threads; the thread that called writes logs and kept vectors and feeds the
// watchdog, as long as every executor has finished a tick since it was fed last.  Where there is one thread, or one executor only
// and nothing to write, it runs all executors itself, whichever is due first, of several the first in the file; that is also how a
// simulation runs, the same in every run.
#ifndef SM_APP_H
#define SM_APP_H

#include "runtime-c/executor.h"
#include "runtime-c/keep.h"
#include "runtime-c/log.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmApp {
    const char *name;
    SmStateVec *sv;
    SmEvents *events;
    SmExecutor *const *executor;
    uint16_t executors;
    void (*set)(void *sv);    // writes the values of [start]; or NULL
    SmKeep *keep;             // or NULL
    SmLog *log;               // or NULL
    uint64_t watchdog;        // nanoseconds; 0: none
    bool one_thread;          // runs all executors in the calling thread even where there are threads
    // What follows is the runtime's; all zero at first.
    bool restored;
    volatile bool stop;       // read and written through sm_app_stop and sm_app_stopping
    const SmTask *failed;     // the task whose init refused
} SmApp;

// Starts it and runs it until sm_app_stop.  Any result but SM_OK is from the start: nothing has run.
SmResult sm_app_run(SmApp *app);

// Ends the application: executors finish their tick, logs are written, sm_app_run returns.  From any task or thread.
void sm_app_stop(SmApp *app);

// sm_app_run with messages on the console; 0, or 1 when it did not start.
int sm_app_main(SmApp *app);

#ifdef __cplusplus
}
#endif
#endif
