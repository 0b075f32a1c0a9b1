// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/app.h with threads, to the nanosecond.  This test has its own platform, on which one thread runs at a time, and a
// clock that advances when all threads sleep.  Each run is therefore the same.
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <string.h>

#include "crew.h"
#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/console.h"
#include "runtime-c/pal/watchdog.h"
#include "tests/test.h"

#define MS ((uint64_t)PAL_MILLISECOND)
enum { THREADS = 6 };                 // thread 0 is the caller of sm_app_run; handles begin at 1

// ---- threads that take turns ----

static struct Thread {
    bool open, ended;
    uint64_t wake;
    unsigned joins;           // the thread whose end it waits for; 0: none
    uint8_t priority;
    PalThreadMain *run;
    void *argument;
    pthread_t thread;
} thread[THREADS];
static unsigned turn;                 // the number of the running thread
static pthread_mutex_t baton = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t passed = PTHREAD_COND_INITIALIZER;
static uint64_t now;
static unsigned misuses;              // calls with a handle that is not open

static struct { bool running, bitten; uint64_t period, fed; unsigned feeds, refuses; } dog;

// Returns the thread that wakes first; of several, the one with the highest priority.
static unsigned next_turn(void)
{
    unsigned best = THREADS;

    for (unsigned i = 0; i < THREADS; i++) {
        const struct Thread *t = &thread[i];
        if (!t->open || t->ended)
            continue;
        if (best == THREADS || t->wake < thread[best].wake || (t->wake == thread[best].wake && t->priority > thread[best].priority))
            best = i;
    }
    return best;
}

// Switches to the thread that wakes next.  Called by the running thread.
static void pass(void)
{
    turn = next_turn();
    now = thread[turn].wake > now ? thread[turn].wake : now;
    dog.bitten = dog.bitten || (dog.running && now - dog.fed > dog.period);
    pthread_cond_broadcast(&passed);
}

static void wait_for_turn(unsigned self)
{
    while (turn != self)
        pthread_cond_wait(&passed, &baton);
}

static void *begin_thread(void *of)
{
    struct Thread *const t = of;

    pthread_mutex_lock(&baton);
    wait_for_turn((unsigned)(t - thread));
    pthread_mutex_unlock(&baton);
    t->run(t->argument);
    pthread_mutex_lock(&baton);
    t->ended = true;
    for (unsigned i = 0; i < THREADS; i++)
        if (thread[i].joins == (unsigned)(t - thread))
            thread[i].wake = now;
    pass();
    pthread_mutex_unlock(&baton);
    return NULL;
}

// ---- the platform ----

SmResult pal_clock_resolution(uint64_t *ns) { return *ns = 1, SM_OK; }
uint64_t pal_clock_now(void) { return now; }

SmResult pal_clock_sleep_until(uint64_t time)
{
    const unsigned self = turn;

    pthread_mutex_lock(&baton);
    thread[self].wake = time > now ? time : now;
    pass();
    wait_for_turn(self);
    pthread_mutex_unlock(&baton);
    return SM_OK;
}

static PalThreadPlan plan[THREADS];

SmResult pal_thread_create(PalThread *handle, const PalThreadPlan *p, PalThreadMain *run, void *argument)
{
    unsigned i = 1;

    while (i < THREADS && thread[i].open)
        i++;
    if (i == THREADS)
        return SM_E_FULL;
    memset(&thread[i], 0, sizeof thread[i]);
    plan[i] = *p;
    thread[i].open = true;
    thread[i].wake = now;
    thread[i].priority = p->priority;
    thread[i].run = run;
    thread[i].argument = argument;
    handle->id = (uint8_t)i;
    return pthread_create(&thread[i].thread, NULL, begin_thread, &thread[i]) == 0 ? SM_OK : SM_E_MEMORY;
}

SmResult pal_thread_join(PalThread handle, uint64_t timeout)
{
    if (handle.id >= THREADS || !thread[handle.id].open) {
        misuses++;
        return SM_E_HANDLE;
    }
    thread[turn].joins = handle.id;
    if (!thread[handle.id].ended)
        pal_clock_sleep_until(now + timeout);
    thread[turn].joins = 0;
    if (!thread[handle.id].ended)
        return SM_E_TIMEOUT;
    pthread_join(thread[handle.id].thread, NULL);
    thread[handle.id].open = false;
    return SM_OK;
}

bool pal_thread_is_realtime(PalThread handle) { return thread[handle.id].priority > 0; }
SmResult pal_thread_set_priority(uint8_t priority) { return thread[turn].priority = priority, SM_OK; }

SmResult pal_watchdog_start(uint64_t period, uint64_t *actual)
{
    memset(&dog, 0, sizeof dog);
    dog.running = true;
    dog.fed = now;
    *actual = dog.period = period;
    return SM_OK;
}
SmResult pal_watchdog_feed(void)
{
    if (dog.refuses > 0)
        return dog.refuses--, SM_E_DEVICE;
    return dog.feeds++, dog.fed = now, SM_OK;
}
SmResult pal_watchdog_stop(void) { return dog.running = false, SM_OK; }
SmResult pal_watchdog_caused_start(bool *bit) { return *bit = false, SM_OK; }

SmResult pal_console_write(const char *text, size_t n) { return (void)text, (void)n, SM_OK; }

SmResult pal_lock_open(PalLock *lock) { return lock->id = 1, SM_OK; }
SmResult pal_lock_close(PalLock lock) { return (void)lock, SM_OK; }
SmResult pal_lock_take(PalLock lock, uint64_t timeout) { return (void)lock, (void)timeout, SM_OK; }
SmResult pal_lock_give(PalLock lock) { return (void)lock, SM_OK; }

// ---- an application: executors of 1 ms with a task each ----

static struct Work { uint64_t at, takes, ended; unsigned calls; bool stops; } work[THREADS];     // what its call number `at` does
static SmTask task[THREADS];
static SmTask *const group[THREADS][1] = {{&task[0]}, {&task[1]}, {&task[2]}};
static SmRate rate[THREADS];
static SmExecutor executor[THREADS];
static SmExecutor *const all[THREADS] = {&executor[0], &executor[1], &executor[2]};
static SmApp app;

static SmResult step(void *context, const SmTick *tick)
{
    struct Work *const w = context;

    (void)tick;
    if (w->calls++ == w->at) {
        if (w->stops)
            sm_app_stop(&app);
        if (w->takes > 0)
            pal_clock_sleep_until(now + w->takes);
    }
    w->ended = now;
    return SM_OK;
}

static void start(uint16_t n)
{
    const SmApp fresh = {.name = "crew", .sv = &crew_vector, .executor = all, .executors = n};

    memset(thread, 0, sizeof thread);
    memset(plan, 0, sizeof plan);
    memset(work, 0, sizeof work);
    memset(&dog, 0, sizeof dog);
    thread[0].open = true;
    turn = 0;
    now = PAL_SECOND;
    misuses = 0;
    crew_vector.guarded = true;
    app = fresh;
    for (int i = 0; i < n; i++) {
        const SmTask t = {.name = "work", .step = step, .context = &work[i], .number = (uint16_t)i};
        const SmRate r = {1, 1, group[i]};
        const SmExecutor e = {.name = "executor", .period = MS, .rate = &rate[i], .rates = 1, .sv = &crew_vector, .unit = MS};

        task[i] = t;
        rate[i] = r;
        executor[i] = e;
    }
}

static uint8_t priority_of_watchdog(void)
{
    for (unsigned i = 1; i < THREADS; i++)
        if (plan[i].name && strcmp(plan[i].name, "watchdog") == 0)
            return plan[i].priority;
    return 255;
}

// "A thread feeds it that is more urgent than all others."  This applies only as far as the platform has priorities.
static void test_watchdog_is_most_urgent(void)
{
    static const uint8_t of_executor[][2] = {{0, 0}, {10, 20}, {40, 1}, {PAL_PRIORITY_MAX - 1, 3}, {PAL_PRIORITY_MAX, 3}};
    static const uint8_t expected[] = {0, 21, 41, PAL_PRIORITY_MAX, PAL_PRIORITY_MAX};

    for (size_t i = 0; i < sizeof expected; i++) {
        start(2);
        app.watchdog = 100 * MS;
        executor[0].priority = of_executor[i][0];
        executor[1].priority = of_executor[i][1];
        work[0].at = 20;
        work[0].stops = true;
        CHECK(sm_app_run(&app) == SM_OK && priority_of_watchdog() == expected[i]);
    }
}

// A medium that is slow, and nothing else to write.
static SmResult restore_nothing(SmApp *a) { return (void)a, SM_OK; }
static void write_slowly(SmApp *a, uint64_t budget) { (void)a, (void)budget, (void)pal_clock_sleep_until(now + 350 * MS); }
static void close_nothing(SmApp *a, const SmTick *last) { (void)a, (void)last; }
static const SmWriting slow = {restore_nothing, write_slowly, close_nothing};

// "It bites when a tick takes longer than it, or when a thread has died".  It does not if the executors have ended normally and the medium needs
// time for the log.
static void test_ended_is_not_stuck(void)
{
    for (unsigned at = 20; at < 80; at++) {
        start(2);
        app.watchdog = 100 * MS;
        app.writing = &slow;
        work[1].at = at;
        work[1].stops = true;
        CHECK(sm_app_run(&app) == SM_OK && now - work[1].ended > 200 * MS && !dog.bitten && !dog.running);
    }
}

// Nor is a last tick that is shorter than the watchdog, no matter which thread ended before.
static void test_last_tick(void)
{
    for (unsigned at = 20; at < 80; at++) {
        start(2);
        app.watchdog = 100 * MS;
        work[1].at = at;
        work[1].stops = true;
        work[1].takes = 95 * MS;
        CHECK(sm_app_run(&app) == SM_OK && work[0].ended + 90 * MS < work[1].ended && !dog.bitten && !dog.running);
    }
}

// The watchdog fires if one thread hangs, whatever the others do.
static void test_stuck(void)
{
    for (unsigned at = 20; at < 80; at++) {
        start(2);
        app.watchdog = 100 * MS;
        work[1].at = at;
        work[1].takes = 140 * MS;
        work[0].at = 300;
        work[0].stops = true;
        CHECK(sm_app_run(&app) == SM_OK && dog.bitten);
    }
}

// The watchdog is fed several times in its period, but not at every check.
static void test_fed_often_enough(void)
{
    start(2);
    app.watchdog = 80 * MS;
    work[0].at = 1000;
    work[0].stops = true;
    CHECK(sm_app_run(&app) == SM_OK && !dog.bitten && dog.feeds >= 45 && dog.feeds <= 55);
}

// "The watchdog is fed as long as no executor is stuck".  A refused feeding does not count, and is repeated at the next check.
static void refuse_for_a_while(SmApp *a, uint64_t budget)
{
    (void)budget;
    if (now - a->start > 200 * MS && dog.refuses == 0 && dog.feeds < 100) {
        dog.refuses = 4;
        dog.feeds += 100;
    }
}
static const SmWriting refusing = {restore_nothing, refuse_for_a_while, close_nothing};

static void test_refused_food(void)
{
    start(2);
    app.watchdog = 100 * MS;
    app.writing = &refusing;
    work[0].at = 1000;
    work[0].stops = true;
    CHECK(sm_app_run(&app) == SM_OK && dog.refuses == 0 && dog.feeds > 120 && !dog.bitten);
}

// Each handle is joined once, because its number may then belong to another thread.
static void test_handles(void)
{
    start(3);
    work[0].at = 20;
    work[0].stops = true;
    CHECK(sm_app_run(&app) == SM_OK && misuses == 0);
    for (unsigned i = 1; i < THREADS; i++)
        CHECK(!thread[i].open);
    for (int i = 0; i < 3; i++)
        CHECK(executor[i].thread.id == 0 && executor[i].ticks == work[i].calls && executor[i].ticks >= 20);
}

// "Executors finish their tick, within a tenth of a second if they wait."
static void test_stop(void)
{
    start(3);
    executor[1].period = 3600 * (uint64_t)PAL_SECOND;
    work[0].at = 50;
    work[0].stops = true;
    work[2].at = 49;
    work[2].takes = 30 * MS;
    CHECK(sm_app_run(&app) == SM_OK && work[1].calls == 1 && work[2].calls == 50);
    CHECK(now - executor[0].start <= 50 * MS + 200 * MS);
}

int main(void)
{
    test_watchdog_is_most_urgent();
    test_ended_is_not_stuck();
    test_last_tick();
    test_stuck();
    test_fed_often_enough();
    test_refused_food();
    test_handles();
    test_stop();
    return test_end("threads");
}
