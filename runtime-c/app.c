// SPDX-License-Identifier: Apache-2.0
// Starts an application, prints why it cannot start, and ends it.  (Running it: run.c.)
#include "runtime-c/app.h"

#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/console.h"
#include "runtime-c/pal/watchdog.h"
#include "runtime-c/run.h"
#include "runtime-c/shared.h"
#include "stdlib/flash.h"

// ---- messages ----

// Prints a flash string (SM_TEXT) on the console, if app->print_messages is set.
void sm_app_print(const SmApp *app, const char *text)
{
    char line[32];                         // small, because on AVR this is part of main's stack frame
    size_t n;

    do {
        for (n = 0; n < sizeof line && (line[n] = sm_text_byte(text)) != '\0'; n++)
            text++;
        if (app->print_messages && n > 0)
            pal_console_write(line, n);
    } while (n == sizeof line);
}

// Prints a name, or nothing for NULL, on the console, if app->print_messages is set.
void sm_app_print_name(const SmApp *app, const char *name)
{
    size_t n = 0;

    while (name && n < UINT16_MAX && name[n])
        n++;
    if (app->print_messages && n > 0)
        pal_console_write(name, n);
}

static void print_what_failed(const SmApp *app)
{
    const bool has_name = app->failed_task || app->failed_executor;

    sm_app_print(app, app->failed_task ? SM_TEXT("task '") : app->failed_executor ? SM_TEXT("executor '") : app->failed_part);
    sm_app_print_name(app, app->failed_task ? app->failed_task->name : app->failed_executor ? app->failed_executor->name : NULL);
    sm_app_print(app, has_name ? SM_TEXT("' does not start: ") : SM_TEXT(" does not start: "));
}

static void print_start_failure(const SmApp *app, SmResult r)
{
    sm_app_print_name(app, app->name);
    sm_app_print(app, SM_TEXT(": "));
    print_what_failed(app);
    sm_app_print_name(app, app->failed_file);
    if (app->failed_file)
        sm_app_print(app, SM_TEXT(": "));
    sm_app_print_name(app, app->failed_pin);
    sm_app_print(app, app->reason ? app->reason : sm_result_text(r));
    sm_app_print(app, SM_TEXT("\n"));
}

// If r is an error, records the part `what` that failed and the reason `why`.  `why` NULL: the text of r is the reason.  Returns r.
static SmResult note_failure(SmApp *app, SmResult r, const char *what, const char *why)
{
    if (r != SM_OK) {
        app->failed_part = what;
        app->reason = why;
    }
    return r;
}

// ---- events ----

static void emit_event(const SmApp *app, SmEventKind kind, uint64_t time, uint32_t a, uint32_t b)
{
    SmEvent e = {time, a, b, 0, 0};

    e.kind = (uint8_t)kind;
    sm_event(app->events, &e);
}

// ---- start ----

// Checks that the platform has a clock and that it advances, by sleeping for its resolution.
static SmResult check_clock(SmApp *app)
{
    uint64_t ns, then;
    SmResult r = pal_clock_resolution(&ns);

    if (r != SM_OK)
        return note_failure(app, r, SM_TEXT("the clock"), NULL);
    then = pal_clock_now() + ns;
    pal_clock_sleep_until(then);
    r = (int64_t)(pal_clock_now() - then) < 0 ? SM_E_DEVICE : SM_OK;
    return note_failure(app, r, SM_TEXT("the clock"), SM_TEXT("it has stopped"));
}

// Checks the rules between parts of the application: it has an executor, and what several threads use has a lock.
static SmResult check_config(SmApp *app)
{
    const bool shared = app->executors > 1 && sm_run_wants_threads(app);

    if (app->executors == 0 || !app->executor)
        return note_failure(app, SM_E_ARGUMENT, SM_TEXT("the application"), SM_TEXT("it has no executor"));
    if (shared && app->sv && !app->sv->guarded)
        return note_failure(app, SM_E_ARGUMENT, SM_TEXT("the state vector"), SM_TEXT("several threads use it, so its .sv must say `lock`"));
    if (shared && app->events && !app->events->guarded)
        return note_failure(app, SM_E_ARGUMENT, SM_TEXT("the event ring"), SM_TEXT("several threads use it, so it must be guarded"));
    if ((app->keep || app->log) && !app->writing)
        return note_failure(app, SM_E_ARGUMENT, SM_TEXT("the log or saved state vector"), SM_TEXT("SmApp.writing is NULL"));
    return check_clock(app);
}

// Opens the locks of the state vector and of the event ring.
static SmResult open_vector(SmApp *app)
{
    SmResult r = app->sv ? sm_statevec_init(app->sv) : SM_OK;

    if (r != SM_OK)
        return note_failure(app, r, SM_TEXT("the state vector"), NULL);
    r = app->events ? sm_events_init(app->events) : SM_OK;
    return note_failure(app, r, SM_TEXT("the event ring"), NULL);
}

// Stores the values of [start], then restores the saved state vector.
static SmResult fill_vector(SmApp *app)
{
    SmResult r;

    if (app->set && app->sv)
        app->set(app->sv->at);
    r = app->writing ? app->writing->restore(app) : SM_OK;
    if (r != SM_OK && !app->failed_part) {                // a service that does not open has recorded itself
        app->failed_part = SM_TEXT("the saved state vector");
        app->failed_file = app->keep ? app->keep->memory : NULL;
    }
    return r;
}

// If `failed_task` is an I/O task, stores "pin N: " in failed_pin for the pin that it could not open.  SM_E_ARGUMENT means an
// invalid table row, which has no pin number to report.
static void store_failed_pin(SmApp *app, SmResult r)
{
    const SmIo *const io = app->failed_task->context == app->inputs ? app->inputs : app->failed_task->context == app->outputs ? app->outputs : NULL;
    char *at = app->failed_pin + sizeof app->failed_pin;
    uint16_t left;

    if (!io || r == SM_E_ARGUMENT)
        return;
    memcpy(at -= 3, ": ", 3);
    left = io->pin[io->failed].pin;
    do {
        *--at = (char)('0' + left % 10);
        left = (uint16_t)(left / 10);
    } while (left != 0);
    memcpy(at -= 4, "pin ", 4);
    memmove(app->failed_pin, at, (size_t)(app->failed_pin + sizeof app->failed_pin - at));
}

// Initialises all executors and their tasks, and records the executor and the task that fail.
static SmResult init_executors(SmApp *app)
{
    SmResult r = SM_OK;

    for (uint16_t i = 0; i < app->executors && r == SM_OK; i++) {
        r = sm_executor_init(app->executor[i], &app->failed_task);
        if (r != SM_OK) {
            app->failed_executor = app->executor[i];
            if (app->failed_task) {
                app->failed_file = app->log && app->failed_task->context == app->log ? app->log->file : NULL;
                store_failed_pin(app, r);
            } else if (r == SM_E_ARGUMENT) {
                app->reason = SM_TEXT("invalid configuration");
            }
        }
    }
    return r;
}

// Whether the watchdog caused this start; false if the platform cannot determine it.
static bool watchdog_caused_start(void)
{
    bool caused = false;

    return pal_watchdog_caused_start(&caused) == SM_OK && caused;
}

static SmResult start_app(SmApp *app)
{
    SmResult r = check_config(app);

    r = r == SM_OK ? open_vector(app) : r;
    r = r == SM_OK ? fill_vector(app) : r;
    if (r != SM_OK)
        return r;
    emit_event(app, SM_EVENT_START, 0, app->restored ? 1 : app->keep && app->keep->unusable ? 2 : 0, watchdog_caused_start());
    r = init_executors(app);
    return r == SM_OK ? sm_run_prepare(app) : r;
}

// ---- from start to end ----

// Emits STOP, which the last record of the log then contains.  If the threads are stopped before tick 0 is due, `now` precedes the
// start, and the time of STOP is 0.
static void end_app(SmApp *app)
{
    const uint64_t now = pal_clock_now();
    const SmTick last = {(int64_t)(now - app->start) > 0 ? now - app->start : 0, 0};

    emit_event(app, SM_EVENT_STOP, last.time, 0, 0);
    if (app->writing)
        app->writing->close(app, &last);
}

// Starts the application and runs it until sm_app_stop.  Any result but SM_OK means that the start failed and nothing has run.
SmResult sm_app_run(SmApp *app)
{
    const SmResult r = start_app(app);

    if (r != SM_OK)
        return r;
    sm_run(app);
    end_app(app);
    return SM_OK;
}

// Makes executors end after their current tick.  May be called from any thread, a signal handler or an interrupt.
void sm_app_stop(SmApp *app)
{
    sm_shared_write(&app->stop, 1);
}

bool sm_app_stopping(const SmApp *app)
{
    return sm_shared_read(&app->stop) != 0;
}

// Calls sm_app_run and prints messages on the console.  Returns 0, or 1 if the application did not start.
int sm_app_main(SmApp *app)
{
    SmResult r;

    app->print_messages = true;
    r = sm_app_run(app);
    if (r != SM_OK)
        print_start_failure(app, r);
    return r != SM_OK;
}
