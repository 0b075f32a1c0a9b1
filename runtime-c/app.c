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

void sm_run_say(const SmApp *app, const char *text)
{
    char line[32];                         // small, because on AVR this is part of main's stack frame
    size_t n;

    do {
        for (n = 0; n < sizeof line && (line[n] = sm_text_byte(text)) != '\0'; n++)
            text++;
        if (app->tell && n > 0)
            pal_console_write(line, n);
    } while (n == sizeof line);
}

void sm_run_say_name(const SmApp *app, const char *name)
{
    size_t n = 0;

    while (name && n < UINT16_MAX && name[n])
        n++;
    if (app->tell && n > 0)
        pal_console_write(name, n);
}

static void tell_who(const SmApp *app)
{
    const bool has_name = app->failed || app->refused;

    sm_run_say(app, app->failed ? SM_TEXT("task '") : app->refused ? SM_TEXT("executor '") : app->what);
    sm_run_say_name(app, app->failed ? app->failed->name : app->refused ? app->refused->name : NULL);
    sm_run_say(app, has_name ? SM_TEXT("' does not start: ") : SM_TEXT(" does not start: "));
}

static void tell_refused(const SmApp *app, SmResult r)
{
    sm_run_say_name(app, app->name);
    sm_run_say(app, SM_TEXT(": "));
    tell_who(app);
    sm_run_say_name(app, app->file);
    if (app->file)
        sm_run_say(app, SM_TEXT(": "));
    sm_run_say_name(app, app->pin);
    sm_run_say(app, app->why ? app->why : sm_result_text(r));
    sm_run_say(app, SM_TEXT("\n"));
}

static SmResult refuse(SmApp *app, SmResult r, const char *what, const char *why)
{
    if (r != SM_OK) {
        app->what = what;
        app->why = why;
    }
    return r;
}

// ---- events ----

static void tell_event(const SmApp *app, SmEventKind kind, uint64_t time, uint32_t a, uint32_t b)
{
    SmEvent e = {time, a, b, 0, 0};

    e.kind = (uint8_t)kind;
    sm_event(app->events, &e);
}

// ---- start ----

static SmResult check_clock(SmApp *app)
{
    uint64_t ns, then;
    SmResult r = pal_clock_resolution(&ns);

    if (r != SM_OK)
        return refuse(app, r, SM_TEXT("the clock"), NULL);
    then = pal_clock_now() + ns;
    pal_clock_sleep_until(then);
    r = (int64_t)(pal_clock_now() - then) < 0 ? SM_E_DEVICE : SM_OK;
    return refuse(app, r, SM_TEXT("the clock"), SM_TEXT("it stands still"));
}

static SmResult check(SmApp *app)
{
    const bool shared = app->executors > 1 && sm_run_wants_threads(app);

    if (app->executors == 0 || !app->executor)
        return refuse(app, SM_E_ARGUMENT, SM_TEXT("the application"), SM_TEXT("it has no executor"));
    if (shared && app->sv && !app->sv->guarded)
        return refuse(app, SM_E_ARGUMENT, SM_TEXT("the state vector"), SM_TEXT("several threads use it, so its .sv must say `lock`"));
    if (shared && app->events && !app->events->guarded)
        return refuse(app, SM_E_ARGUMENT, SM_TEXT("the ring of events"), SM_TEXT("several threads use it, so it must be guarded"));
    if ((app->keep || app->log) && !app->writing)
        return refuse(app, SM_E_ARGUMENT, SM_TEXT("the log or kept state vector"), SM_TEXT("SmApp.writing is missing"));
    return check_clock(app);
}

static SmResult open_vector(SmApp *app)
{
    SmResult r = app->sv ? sm_statevec_init(app->sv) : SM_OK;

    if (r != SM_OK)
        return refuse(app, r, SM_TEXT("the state vector"), NULL);
    r = app->events ? sm_events_init(app->events) : SM_OK;
    return refuse(app, r, SM_TEXT("the ring of events"), NULL);
}

static SmResult fill_vector(SmApp *app)
{
    SmResult r;

    if (app->set && app->sv)
        app->set(app->sv->at);
    r = refuse(app, app->writing ? app->writing->restore(app) : SM_OK, SM_TEXT("the kept state vector"), NULL);
    app->file = r != SM_OK && app->keep ? app->keep->memory : NULL;
    return r;
}

// Stores the name of the pin that the I/O task `failed` could not open.  An invalid table row has no pin number to report.
static void name_pin(SmApp *app, SmResult r)
{
    const SmIo *const io = app->failed->context == app->inputs ? app->inputs : app->failed->context == app->outputs ? app->outputs : NULL;
    char *at = app->pin + sizeof app->pin;
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
    memmove(app->pin, at, (size_t)(app->pin + sizeof app->pin - at));
}

static SmResult init_executors(SmApp *app)
{
    SmResult r = SM_OK;

    for (uint16_t i = 0; i < app->executors && r == SM_OK; i++) {
        r = sm_executor_init(app->executor[i], &app->failed);
        if (r != SM_OK) {
            app->refused = app->executor[i];
            if (app->failed) {
                app->file = app->log && app->failed->context == app->log ? app->log->file : NULL;
                name_pin(app, r);
            } else if (r == SM_E_ARGUMENT) {
                app->why = SM_TEXT("its plan is wrong");
            }
        }
    }
    return r;
}

static bool has_bitten(void)
{
    bool bit = false;

    return pal_watchdog_bit(&bit) == SM_OK && bit;
}

static SmResult start(SmApp *app)
{
    SmResult r = check(app);

    r = r == SM_OK ? open_vector(app) : r;
    r = r == SM_OK ? fill_vector(app) : r;
    if (r != SM_OK)
        return r;
    tell_event(app, SM_EVENT_START, 0, app->restored ? 1 : app->keep && app->keep->unusable ? 2 : 0, has_bitten());
    r = init_executors(app);
    return r == SM_OK ? sm_run_prepare(app) : r;
}

// ---- from start to end ----

// The last record of the log contains STOP.  If the threads are stopped before tick 0 is due, the end precedes the start.
static void end(SmApp *app)
{
    const uint64_t now = pal_clock_now();
    const SmTick last = {(int64_t)(now - app->start) > 0 ? now - app->start : 0, 0};

    tell_event(app, SM_EVENT_STOP, last.time, 0, 0);
    if (app->writing)
        app->writing->close(app, &last);
}

SmResult sm_app_run(SmApp *app)
{
    const SmResult r = start(app);

    if (r != SM_OK)
        return r;
    sm_run(app);
    end(app);
    return SM_OK;
}

void sm_app_stop(SmApp *app)
{
    sm_shared_write(&app->stop, 1);
}

bool sm_app_stopping(const SmApp *app)
{
    return sm_shared_read(&app->stop) != 0;
}

int sm_app_main(SmApp *app)
{
    SmResult r;

    app->tell = true;
    r = sm_app_run(app);
    if (r != SM_OK)
        tell_refused(app, r);
    return r != SM_OK;
}
