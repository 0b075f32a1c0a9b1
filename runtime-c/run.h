// SPDX-License-Identifier: Apache-2.0
// How an application that has started runs: in one thread or in several, and its watchdog.  Between app.c and run.c alone.
#ifndef SM_RUN_H
#define SM_RUN_H

#include "runtime-c/app.h"

#ifdef __cplusplus
extern "C" {
#endif

// Whether executors are to have threads of their own, if the platform has threads.
bool sm_run_wants_threads(const SmApp *app);

// Creates the threads, which wait, and starts the watchdog.  Where that is refused the threads have ended again.
SmResult sm_run_prepare(SmApp *app);

// Runs until the application is to stop and all ticks have ended; then stops the watchdog.
void sm_run(SmApp *app);

// On the console, if it is wanted: a text (SM_TEXT, flash.h); a name, or NULL.
void sm_run_say(const SmApp *app, const char *text);
void sm_run_say_name(const SmApp *app, const char *name);

#ifdef __cplusplus
}
#endif
#endif
