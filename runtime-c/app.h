// SPDX-License-Identifier: Apache-2.0
// A whole application: its state vector, its executors with their tasks, what is kept and logged.  Made by smc from a .app file
// (docs/config.md), with a main that is one call: sm_app_main(&rocket_app).
//
// Start, in this order: the clock; the locks of state vector and events; the values of [start]; the kept vector, where there is one; init
// of all tasks, executor by executor; the threads; the watchdog; tick 0 of all executors, at one moment.  What is refused on the way
// is told on the console, and nothing runs.
//
// Each executor has a thread, where the platform has threads; the thread that called writes logs and kept vectors, for which it
// may have to wait.  Where there is one thread, or one executor only and nothing to write, it runs all executors itself, and writes
// while none is due (ten times a second whatever is due).  It takes the one that has waited longest, since its tick was due or since its last tick ended, whichever
// was later; of several the first in the file.  So an executor that is always late keeps no other waiting for more than one tick of
// each, and a simulation runs the same in every run.
//
// The watchdog is fed as long as no executor is stuck: each has finished a tick since it was fed last, or has none that was due by
// then.  It bites when a tick takes longer than it, or when a thread has died.  (A thread feeds it that is more urgent than all others.)
#ifndef SM_APP_H
#define SM_APP_H

#include "runtime-c/executor.h"
#include "runtime-c/io.h"
#include "runtime-c/keep.h"
#include "runtime-c/log.h"

#ifdef __cplusplus
extern "C" {
#endif

struct SmApp;

// What brings kept vectors and logs to their media: apart, so that a program that has neither does not carry it.
typedef struct SmWriting {
    SmResult (*restore)(struct SmApp *app);               // before the tasks' init
    void (*write)(struct SmApp *app, uint64_t budget);    // what waits; logs for at most `budget` nanoseconds
    void (*close)(struct SmApp *app, const SmTick *last); // a last record, then all that waits
} SmWriting;

extern const SmWriting sm_writing;

typedef struct SmApp {
    const char *name;
    SmStateVec *sv;
    SmEvents *events;
    SmExecutor *const *executor;
    uint16_t executors;
    void (*set)(void *sv);    // writes the values of [start]; or NULL
    SmKeep *keep;             // or NULL
    SmLog *log;               // or NULL
    const SmWriting *writing; // &sm_writing where there is `keep` or `log`; else NULL
    const SmIo *inputs, *outputs;         // the contexts of the two I/O tasks, so that a message can name the pin; or NULL
    uint64_t watchdog;        // nanoseconds; 0: none
    bool one_thread;          // runs all executors in the calling thread even where there are threads
    // What follows is the runtime's; all zero at first.
    bool restored;
    uint32_t stop;            // read and written through sm_app_stop and sm_app_stopping
    const SmTask *failed;     // the task whose init refused
    const SmExecutor *refused;            // the executor that did not start, or whose task it was
    const char *what, *why;   // what else did not start; why, where the result does not say it: texts (stdlib/flash.h)
    const char *file;         // that it is about; or NULL
    char pin[16];             // "pin 17: ", likewise; or empty
    bool tell;                // on the console
    uint64_t start;           // on the PAL clock: when tick 0 is due
    uint64_t fed, wrote;      // on the PAL clock: when the watchdog was fed last; when logs and kept vectors were looked after last
    PalThread watch;          // the thread that feeds it
    uint32_t gate;            // run.c
} SmApp;

// Starts it and runs it until sm_app_stop.  Any result but SM_OK is from the start: nothing has run.  Once in a program.
SmResult sm_app_run(SmApp *app);

// Ends the application: executors finish their tick, within a tenth of a second if they wait; what is dangerous is brought to rest: every
// task that has `safe` and is not disabled is called so once, executor by executor, outputs too; the watchdog is stopped; logs are written;
// sm_app_run returns.  From any task or thread, from a signal handler or an interrupt as well.  Outputs stay as they are.
void sm_app_stop(SmApp *app);

bool sm_app_stopping(const SmApp *app);

// sm_app_run with messages on the console; 0, or 1 when it did not start.
//     rocket: task 'engine' does not start: it is in use
//     rocket: task 'log' does not start: flight.log: there is no such device, file or address
//     rocket: task 'inputs' does not start: pin 17: it is in use
int sm_app_main(SmApp *app);

#ifdef __cplusplus
}
#endif
#endif
