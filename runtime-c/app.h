// SPDX-License-Identifier: Apache-2.0
// An application: its state vector, its executors with their tasks, its log, and the state vector that it saves in non-volatile
// memory. smc generates it from a .app file (docs/config.md).  Its main function is one call: sm_app_main(&rocket_app).
//
// Start-up steps, in this order:
// 1. Check the clock.
// 2. Open the locks of the state vector and of the events.
// 3. Store the values of [start].
// 4. Restore the saved state vector, if there is one.
// 5. Call init of all tasks, executor by executor.
// 6. Create the threads.
// 7. Start the watchdog.
// 8. Start tick 0 of all executors at the same time.
// If a step fails, nothing runs, and sm_app_main prints the reason on the console.
//
// On a platform with threads, each executor has its own thread.  The thread that called sm_app_run writes the log and the saved
// state vector, because it may wait for the media.  The calling thread runs all executors itself if there is only one thread, or
// if there is only one executor and nothing to write.  It then writes while no executor is due, and ten times a second even if one
// is due.
//
// One thread with several executors runs the one that has waited longest.  An executor waits since its tick was due or since its
// last tick ended, whichever is later.  Ties go to the first in the file.  So an executor that is always late delays every other
// one by at most one tick of each.  A simulation runs the same way every time.
//
// The watchdog is fed while no executor is stuck.  An executor is not stuck if it has finished a tick since the last feed, or had
// none due by then.  The watchdog fires when a tick takes longer than its period, or when a thread has died.  On a platform with
// threads, the thread that feeds it has a higher priority than all others.
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

// Writes saved state vectors and logs to their media.  A separate struct, so that a program that has neither does not link this
// code.
typedef struct SmWriting {
    SmResult (*restore)(struct SmApp *app);               // restores the saved state vector, before init of the tasks
    void (*write)(struct SmApp *app, uint64_t budget);    // writes pending data; log data for at most `budget` nanoseconds
    void (*close)(struct SmApp *app, const SmTick *last); // appends a last record, then writes everything pending
} SmWriting;

extern const SmWriting sm_writing;

typedef struct SmApp {
    const char *name;
    SmStateVec *sv;
    SmEvents *events;
    SmExecutor *const *executor;
    uint16_t executors;
    void (*set)(void *sv);    // stores the values of [start]; or NULL
    SmKeep *keep;             // saves the state vector; or NULL
    SmLog *log;               // the flight log; or NULL
    const SmWriting *writing; // &sm_writing if `keep` or `log` is set; else NULL
    const SmIo *inputs, *outputs;         // the contexts of the two I/O tasks, so that a message can name the pin; or NULL
    uint64_t watchdog;        // period of the watchdog in nanoseconds; 0: no watchdog
    bool one_thread;          // runs all executors in the calling thread, even on a platform with threads
    // The fields below belong to the runtime; initially all zero.
    bool restored;
    uint32_t stop;            // read and written through sm_app_stop and sm_app_stopping
    const SmTask *failed_task;  // the task whose init failed
    const SmExecutor *failed_executor;    // the executor that did not start, or to which `failed_task` belongs
    const char *failed_part;  // the part, neither task nor executor, that did not start (a flash string: stdlib/flash.h); or NULL
    const char *reason;       // why the start failed (a flash string); NULL: the text of the SmResult is the reason
    const char *failed_file;  // the file that the failure concerns; or NULL
    char failed_pin[16];      // the pin that the failure concerns, as "pin 17: "; or empty
    bool print_messages;      // print messages on the console
    uint64_t start;           // PAL clock time at which tick 0 is due
    uint64_t fed_at, wrote_at;// PAL clock times: of the last watchdog feed; of the last check for pending writes
    PalThread watchdog_thread;// the thread that feeds the watchdog
    uint32_t gate;            // GATE_WAIT, GATE_OPEN or GATE_CLOSED (run.c): what the threads wait for
} SmApp;

// Starts the application and runs it until sm_app_stop.  Any result but SM_OK means that the start failed and nothing has run.  To
// be called once in a program.
SmResult sm_app_run(SmApp *app);

// Ends the application:
// 1. Executors finish their current tick.  A waiting executor ends within a tenth of a second.
// 2. Every task that has `safe` and is not disabled has it called once, executor by executor, including the outputs task.
// 3. The watchdog is stopped and the logs are written.
// 4. sm_app_run returns.
// May be called from any task or thread, from a signal handler or an interrupt.  The outputs stay as step 2 left them.
void sm_app_stop(SmApp *app);

bool sm_app_stopping(const SmApp *app);

// Calls sm_app_run and prints messages on the console.  Returns 0, or 1 if the application did not start.  Examples:
//     rocket: task 'engine' does not start: it is in use
//     rocket: task 'log' does not start: flight.log: there is no such device, file or address
//     rocket: task 'inputs' does not start: pin 17: it is in use
int sm_app_main(SmApp *app);

#ifdef __cplusplus
}
#endif
#endif
