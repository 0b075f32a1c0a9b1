// SPDX-License-Identifier: Apache-2.0
// Runs the executors of an application, all in one thread or each in its own.  PAL clock times are compared by their difference.
#include "runtime-c/run.h"

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/thread.h"
#include "runtime-c/pal/watchdog.h"
#include "runtime-c/shared.h"
#include "stdlib/flash.h"

#define STOP_CHECK_INTERVAL (100 * (uint64_t)PAL_MILLISECOND)    // longest sleep before `stop` is checked again
#define WRITE_INTERVAL      (10 * (uint64_t)PAL_MILLISECOND)     // with threads: time between two writes of pending data
#define GATE_POLL_INTERVAL  ((uint64_t)PAL_MILLISECOND)          // time between two checks of a thread that waits at the gate

// SmApp.gate.  All threads wait until it is open.  Then executor threads run until the application stops, and the watchdog thread
// until the gate is closed.
enum { GATE_WAIT, GATE_OPEN, GATE_CLOSED };

static uint64_t shorter_of(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

// Returns the time from `now` to `then`; 0 if `then` has passed.
static uint64_t time_until(uint64_t now, uint64_t then)
{
    return (int64_t)(then - now) > 0 ? then - now : 0;
}

// ---- the watchdog ----

// Returns the check interval of the watchdog thread.
static uint64_t watchdog_check_interval(const SmApp *app)
{
    return app->watchdog / 8 > PAL_MILLISECOND ? app->watchdog / 8 : PAL_MILLISECOND;
}

// Returns the number of the next tick of e, from the low 32 bits that the executor's thread publishes.
static uint64_t next_tick_number(const SmExecutor *e)
{
    return e->next_at_feed + (uint32_t)(sm_shared_read(&e->next_shared) - (uint32_t)e->next_at_feed);
}

// Whether e has finished no tick since the watchdog was fed at `fed`, although one was due by then.
static bool is_executor_stuck(const SmExecutor *e, uint64_t fed)
{
    const uint64_t next = next_tick_number(e);

    return next == e->next_at_feed && time_until(fed, e->start + next * e->period) == 0 && !sm_shared_read(&e->done);
}

// Feeds the watchdog if a quarter of its period has passed since the last feed and no executor is stuck.
static void feed_watchdog(SmApp *app, uint64_t now)
{
    if (app->watchdog == 0 || now - app->fed_at < app->watchdog / 4)
        return;
    for (uint16_t i = 0; i < app->executors; i++)
        if (is_executor_stuck(app->executor[i], app->fed_at))
            return;
    if (pal_watchdog_feed() != SM_OK)
        return;
    for (uint16_t i = 0; i < app->executors; i++)
        app->executor[i]->next_at_feed = next_tick_number(app->executor[i]);
    app->fed_at = now;
}

static SmResult start_watchdog(SmApp *app)
{
    uint64_t actual;
    SmResult r;

    if (app->watchdog == 0)
        return SM_OK;
    r = pal_watchdog_start(app->watchdog, &actual);
    if (r != SM_OK)
        app->failed_part = SM_TEXT("the watchdog");
    return r;
}

// Writes pending data of the log, for at most `budget` nanoseconds, and the pending snapshot of the state vector.
static void write_pending(SmApp *app, uint64_t now, uint64_t budget)
{
    app->wrote_at = now;
    if (app->writing)
        app->writing->write(app, budget);
}

// ---- one thread ----

// Runs the next tick of e, then publishes the number of the following one to the thread that feeds the watchdog.
static void run_tick(SmExecutor *e)
{
    sm_executor_tick(e);
    sm_shared_write(&e->next_shared, (uint32_t)e->next);
}

// Returns the time, counted from the start, at which e began to wait: its next tick was due, and its last one had ended.
static uint64_t waiting_since(const SmApp *app, const SmExecutor *e)
{
    const uint64_t due = sm_executor_due(e) - app->start, ended = e->ended - app->start;

    return due > ended ? due : ended;
}

// Returns the executor that has waited longest.  If several have, returns the first in the table.
static SmExecutor *longest_waiting(const SmApp *app)
{
    SmExecutor *best = app->executor[0];

    for (uint16_t i = 1; i < app->executors; i++)
        if (waiting_since(app, app->executor[i]) < waiting_since(app, best))
            best = app->executor[i];
    return best;
}

// Waits until `then`, but at most until `stop` or the watchdog must be checked.  Writes pending data meanwhile.
static void write_and_sleep(SmApp *app, uint64_t now, uint64_t then)
{
    const uint64_t longest = app->watchdog > 0 ? shorter_of(STOP_CHECK_INTERVAL, watchdog_check_interval(app)) : STOP_CHECK_INTERVAL;
    const uint64_t end = now + shorter_of(longest, time_until(now, then));

    write_pending(app, now, end - now);
    pal_clock_sleep_until(end);
}

// Runs the ticks of all executors in the calling thread, always of the one that has waited longest, until the application stops.
static void run_in_this_thread(SmApp *app)
{
    while (!sm_app_stopping(app)) {
        SmExecutor *const e = longest_waiting(app);
        const uint64_t now = pal_clock_now(), due = sm_executor_due(e);

        feed_watchdog(app, now);
        if (time_until(now, due) > 0)
            write_and_sleep(app, now, due);
        else
            run_tick(e);
        if (now - app->wrote_at >= STOP_CHECK_INTERVAL)
            write_pending(app, now, 0);
    }
}

// ---- several threads ----

static void sleep_for(uint64_t ns)
{
    pal_clock_sleep_until(pal_clock_now() + ns);
}

// Waits until app->gate says that all threads exist, or that the start has failed.
static void wait_at_gate(const SmApp *app)
{
    while (sm_shared_read(&app->gate) == GATE_WAIT)
        sleep_for(GATE_POLL_INTERVAL);
}

// Waits until the next tick is due.  Returns false if the application is stopping.
static bool wait_for_tick(const SmExecutor *e)
{
    while (!sm_app_stopping(e->app)) {
        const uint64_t now = pal_clock_now(), left = time_until(now, sm_executor_due(e));

        if (left == 0)
            return true;
        pal_clock_sleep_until(now + shorter_of(left, STOP_CHECK_INTERVAL));
    }
    return false;
}

// The thread of an executor: runs its ticks from the opening of the gate until the application stops.
static void executor_thread_main(void *of)
{
    SmExecutor *const e = of;

    wait_at_gate(e->app);
    if (sm_shared_read(&e->app->gate) == GATE_OPEN)
        while (wait_for_tick(e))
            run_tick(e);
    sm_shared_write(&e->done, 1);
}

// The thread that feeds the watchdog, from the opening of the gate until it is closed.
static void watchdog_thread_main(void *of)
{
    SmApp *const app = of;

    wait_at_gate(app);
    while (sm_shared_read(&app->gate) == GATE_OPEN) {
        feed_watchdog(app, pal_clock_now());
        sleep_for(watchdog_check_interval(app));
    }
}

// Writes pending data until the threads of all executors have ended: the work of the calling thread while they run.
static void write_until_threads_end(SmApp *app)
{
    while (!sm_app_stopping(app)) {
        write_pending(app, app->start, WRITE_INTERVAL);
        sleep_for(app->writing ? WRITE_INTERVAL : STOP_CHECK_INTERVAL);
    }
    for (uint16_t i = 0; i < app->executors; i++) {
        while (pal_thread_join(app->executor[i]->thread, WRITE_INTERVAL) == SM_E_TIMEOUT)
            write_pending(app, app->start, WRITE_INTERVAL);
        app->executor[i]->thread.id = 0;      // the number may be reused for another thread
    }
}

// ---- creating threads ----

// Whether executors get their own threads if the platform has threads.
bool sm_run_wants_threads(const SmApp *app)
{
    return !app->one_thread && (app->executors > 1 || app->writing);
}

// Returns the highest priority of an executor.
static uint8_t highest_priority(const SmApp *app)
{
    uint8_t p = 0;

    for (uint16_t i = 0; i < app->executors; i++)
        p = app->executor[i]->priority > p ? app->executor[i]->priority : p;
    return p;
}

// Prints a warning: the executor `name` runs, but without its real-time priority.
static void print_priority_denied(const SmApp *app, const char *name)
{
    sm_app_print_name(app, app->name);
    sm_app_print(app, SM_TEXT(": executor '"));
    sm_app_print_name(app, name);
    sm_app_print(app, SM_TEXT("' runs without its real-time priority: "));
    sm_app_print(app, sm_result_text(SM_E_DENIED));
    sm_app_print(app, SM_TEXT("\n"));
}

static SmResult create_executor_thread(SmApp *app, SmExecutor *e)
{
    const PalThreadPlan plan = {e->name, e->priority, 0};
    const SmResult r = pal_thread_create(&e->thread, &plan, executor_thread_main, e);

    if (r == SM_OK && e->priority > 0 && !pal_thread_is_realtime(e->thread))
        print_priority_denied(app, e->name);
    if (r != SM_OK) {
        app->failed_executor = e;
        app->reason = r == SM_E_FULL ? SM_TEXT("there are more executors than threads (PAL_THREADS)") : NULL;
    }
    return r;
}

// Creates the thread that feeds the watchdog.  Where possible, its priority is above that of every executor, so that a busy executor cannot
// delay it.
static SmResult create_watchdog_thread(SmApp *app)
{
    PalThreadPlan plan = {"watchdog", 0, 0};
    SmResult r;

    plan.priority = highest_priority(app);
    plan.priority = (uint8_t)(plan.priority + (plan.priority > 0 && plan.priority < PAL_PRIORITY_MAX));
    r = pal_thread_create(&app->watchdog_thread, &plan, watchdog_thread_main, app);
    if (r != SM_OK)
        app->failed_part = SM_TEXT("the watchdog's thread");
    return r;
}

static void join_thread(PalThread *thread)
{
    while (thread->id != 0 && pal_thread_join(*thread, STOP_CHECK_INTERVAL) == SM_E_TIMEOUT) {}
    thread->id = 0;
}

// Ends all threads: those that still wait at the gate return at their next check, and the watchdog thread returns after its sleep.
static void close_gate(SmApp *app)
{
    sm_shared_write(&app->gate, GATE_CLOSED);
    for (uint16_t i = 0; i < app->executors; i++)
        join_thread(&app->executor[i]->thread);
    join_thread(&app->watchdog_thread);
}

static SmResult create_threads(SmApp *app)
{
    SmResult r = SM_OK;

    for (uint16_t i = 0; i < app->executors && r == SM_OK; i++)
        r = create_executor_thread(app, app->executor[i]);
    if (r == SM_OK && app->watchdog > 0)
        r = create_watchdog_thread(app);
    return r;
}

// ---- start and run ----

// Creates the threads, which wait, and starts the watchdog.  If it fails, no thread is left running.
SmResult sm_run_prepare(SmApp *app)
{
    SmResult r = SM_E_UNSUPPORTED;

    for (uint16_t i = 0; i < app->executors; i++)
        app->executor[i]->app = app;
    if (sm_run_wants_threads(app))
        r = create_threads(app);
    if (r == SM_E_UNSUPPORTED) {          // no threads: the calling thread runs all executors
        app->failed_executor = NULL;
        r = SM_OK;
    }
    if (r == SM_OK)
        r = start_watchdog(app);
    if (r != SM_OK)
        close_gate(app);
    return r;
}

// Sets the due time of tick 0 late enough for all threads to see the gate open.
static void open_gate(SmApp *app, bool threads)
{
    app->start = app->fed_at = app->wrote_at = pal_clock_now();
    app->start += threads ? 5 * GATE_POLL_INTERVAL : 0;
    for (uint16_t i = 0; i < app->executors; i++)
        sm_executor_start(app->executor[i], app->start);
    sm_shared_write(&app->gate, GATE_OPEN);
}

// Runs all executors in the calling thread, with the highest of their priorities.
static void run_without_threads(SmApp *app)
{
    const uint8_t priority = highest_priority(app);
    const SmResult r = priority > 0 ? pal_thread_set_priority(priority) : SM_E_UNSUPPORTED;

    if (r != SM_OK && r != SM_E_UNSUPPORTED)
        print_priority_denied(app, app->executor[0]->name);
    open_gate(app, false);
    run_in_this_thread(app);
    if (r == SM_OK)
        pal_thread_set_priority(0);
}

// Runs until the application stops and all ticks have ended, then stops the watchdog.
void sm_run(SmApp *app)
{
    if (app->executor[0]->thread.id == 0) {
        run_without_threads(app);
    } else {
        open_gate(app, true);
        write_until_threads_end(app);
        close_gate(app);
    }
    for (uint16_t i = 0; i < app->executors; i++)
        sm_executor_safe(app->executor[i]);
    if (app->watchdog > 0)
        pal_watchdog_stop();
}
