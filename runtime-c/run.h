// SPDX-License-Identifier: Apache-2.0
// Internal to app.c and run.c: runs an application that has started, in one thread or several, and feeds its watchdog.
#ifndef SM_RUN_H
#define SM_RUN_H

#include "runtime-c/app.h"

#ifdef __cplusplus
extern "C" {
#endif

// Whether executors get their own threads if the platform has threads.
bool sm_run_wants_threads(const SmApp *app);

// Creates the threads, which wait, and starts the watchdog.  If it fails, no thread is left running.
SmResult sm_run_prepare(SmApp *app);

// Runs until the application stops and all ticks have ended, then stops the watchdog.
void sm_run(SmApp *app);

// Print on the console if app->print_messages is set: a flash string (SM_TEXT, flash.h); a name, or nothing for NULL.
void sm_app_print(const SmApp *app, const char *text);
void sm_app_print_name(const SmApp *app, const char *name);

#ifdef __cplusplus
}
#endif
#endif
