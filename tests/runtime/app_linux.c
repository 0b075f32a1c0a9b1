// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/app.h with threads: each executor has its own thread, any thread can stop the application at any time, and the
// watchdog works.
#define _GNU_SOURCE
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "crew.h"
#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/shared.h"
#include "tests/test.h"

#define MS ((uint64_t)PAL_MILLISECOND)
#define CREW(name) (&crew_element[CREW_E_##name])
#define MANY 10

// A task's context: the values that it has read.
typedef struct Seen {
    uint64_t calls, last, g;
    bool in_order;
    int policy;
    pthread_t thread;
    uint64_t stop_at;         // the tick in which it stops the application; 0: none
    bool hang;
} Seen;

static Seen seen[MANY];
static SmTask task[MANY];
static SmTask *group[MANY][1];
static SmRate rate[MANY];
static SmExecutor executor[MANY];
static SmExecutor *all[MANY];
static SmEvent storage[64];
static SmEvents events;
static SmApp app;

static SmResult step(void *context, const SmTick *tick)
{
    Seen *const s = context;
    const uint64_t g = crew_time();

    s->in_order = s->in_order && (s->calls == 0 || tick->number > s->last) && g >= s->g && g * MS >= tick->time;
    s->calls++;
    s->last = tick->number;
    s->g = g;
    s->policy = sched_getscheduler(0);
    s->thread = pthread_self();
    crew_set_number(crew_number() + 1);
    if (s->stop_at > 0 && tick->number >= s->stop_at)
        sm_app_stop(&app);
    while (s->hang) {}
    return SM_OK;
}

static void prepare_executor(int i, uint64_t period)
{
    const Seen fresh = {.in_order = true};
    const SmTask t = {.name = "task", .step = step, .context = &seen[i], .mode = CREW(first), .number = (uint16_t)i};
    const SmRate r = {1, 1, group[i]};
    const SmExecutor e = {.name = "executor", .period = period, .rate = &rate[i], .rates = 1, .sv = &crew_vector, .events = &events,
                          .time = CREW(time), .unit = MS, .vitals = {CREW(v_u64), CREW(v_u32), CREW(v_u8), CREW(v_i16), CREW(v_i8)}};

    seen[i] = fresh;
    task[i] = t;
    rate[i] = r;
    executor[i] = e;
    group[i][0] = &task[i];
    all[i] = &executor[i];
}

// Prepares n executors of 1 ms, 2 ms, 3 ms …
static void prepare_app(uint16_t n)
{
    const SmApp fresh = {.name = "crew", .sv = &crew_vector, .events = &events, .executor = all, .executors = n};
    const SmEvents ring = {storage, 64, true, {0}, 0, 0};

    memset(&crew_sv, 0, sizeof crew_sv);
    crew_sv.first = SM_ENABLED;
    crew_vector.guarded = true;
    events = ring;
    app = fresh;
    for (int i = 0; i < n; i++)
        prepare_executor(i, (uint64_t)(i + 1) * MS);
}

// Runs the application and then releases its locks, because their number is limited.
static SmResult run_app(void)
{
    const SmResult r = sm_app_run(&app);

    if (events.guarded)
        pal_lock_close(events.lock);
    if (crew_vector.guarded)
        pal_lock_close(crew_vector.lock);
    return r;
}

static bool counts_agree(int i)
{
    const SmExecutor *const e = &executor[i];

    return e->ticks + e->skipped == e->next && e->ticks == seen[i].calls && seen[i].in_order && task[i].steps == (uint32_t)e->ticks;
}

static bool all_counts_agree(void)
{
    bool good = true;

    for (int i = 0; i < app.executors; i++)
        good = good && counts_agree(i);
    return good;
}

// ---- stop ----

static void test_stop_by_task(void)
{
    prepare_app(3);
    seen[2].stop_at = 30;
    CHECK(run_app() == SM_OK && all_counts_agree());
    CHECK(seen[2].last >= 30 && executor[0].next >= 45 && executor[1].next >= 22);
    CHECK(!pthread_equal(seen[0].thread, seen[1].thread) && !pthread_equal(seen[0].thread, pthread_self()));
    CHECK(crew_sv.number > 0 && crew_vector.faults == 0 && executor[0].start == executor[2].start);
}

static uint32_t random_number(uint32_t below)
{
    static uint32_t x = 2463534242u;

    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x % below;
}

static void *stop_later(void *of)
{
    pal_clock_sleep_until(pal_clock_now() + *(const uint64_t *)of);
    sm_app_stop(&app);
    return NULL;
}

// Another thread stops the application at a random time, also before the first tick.
static void test_stop_at_random(void)
{
    for (int i = 0; i < 30; i++) {
        uint64_t after = random_number(i % 4 == 0 ? 1000000 : 12000000);
        pthread_t stopper;

        prepare_app((uint16_t)(1 + random_number(5)));
        CHECK(pthread_create(&stopper, NULL, stop_later, &after) == 0);
        CHECK(run_app() == SM_OK && all_counts_agree());
        CHECK(pthread_join(stopper, NULL) == 0);
    }
}

// A stop before tick 0 is due.  Tick 0 is due a little after the start, because time does not begin before 0.
static void test_stop_at_once(void)
{
    uint32_t cursor = 0;
    SmEvent told[3];

    prepare_app(2);
    sm_app_stop(&app);
    CHECK(run_app() == SM_OK && seen[0].calls == 0);
    events.guarded = false;                                // its lock is closed
    CHECK(sm_events_read(&events, &cursor, told, 3, NULL) == 2 && told[1].kind == SM_EVENT_STOP && told[1].time < PAL_SECOND);
}

static void on_alarm(int signal)                       // sent repeatedly until the application is running
{
    (void)signal;
    if (sm_shared_read(&executor[0].next_shared) > 0)
        sm_app_stop(&app);
}

static void test_stop_by_signal(void)
{
    prepare_app(2);
    signal(SIGALRM, on_alarm);
    ualarm(20000, 20000);
    CHECK(run_app() == SM_OK && all_counts_agree() && executor[0].next > 0);
    ualarm(0, 0);
}

// A stop ends a sleep of an hour.
static void test_stop_asleep(void)
{
    const uint64_t began = pal_clock_now();

    prepare_app(2);
    prepare_executor(1, 3600 * (uint64_t)PAL_SECOND);
    seen[0].stop_at = 50;
    CHECK(run_app() == SM_OK && all_counts_agree() && seen[1].calls == 1 && pal_clock_now() - began < 5 * (uint64_t)PAL_SECOND);
}

// ---- one executor, one thread ----

static void test_alone(void)
{
    prepare_app(1);
    crew_vector.guarded = events.guarded = false;
    seen[0].stop_at = 30;
    CHECK(run_app() == SM_OK && all_counts_agree() && pthread_equal(seen[0].thread, pthread_self()));
}

static void test_one_thread(void)
{
    prepare_app(3);
    app.one_thread = true;
    crew_vector.guarded = events.guarded = false;
    seen[2].stop_at = 20;
    CHECK(run_app() == SM_OK && all_counts_agree() && pthread_equal(seen[1].thread, pthread_self()));
}

// Periods of a microsecond, which no thread can meet, in one thread and in several.
static void test_too_fast(void)
{
    for (int i = 0; i < 4; i++) {
        prepare_app(2);
        app.one_thread = i % 2 == 0;
        executor[0].period = 1000;
        executor[0].overrun = i < 2 ? SM_SKIP : SM_CATCH_UP;
        executor[0].most = 100;
        seen[1].stop_at = 20;
        CHECK(run_app() == SM_OK && counts_agree(1) && executor[0].ticks + executor[0].skipped == executor[0].next && executor[0].ticks > 1);
    }
}

// ---- a log and a kept vector: the thread that called writes them ----

static void test_written(void)
{
    static uint8_t ring[65536], slots[2 * SM_KEEP_SIZE(sizeof crew_sv)];
    char folder[] = P_tmpdir "/smc-app.XXXXXX";
    SmLog log = {.file = "flight", .sv = &crew_vector, .names = &crew_names, .events = &events, .buffer = ring, .room = sizeof ring};
    SmKeep keep = {.memory = "kept", .sv = &crew_vector, .buffer = slots};
    const SmTask record = {.name = "log", .init = sm_log_init, .step = sm_log_step, .context = &log},
                 snapshot = {.name = "keep", .step = sm_keep_step, .context = &keep};

    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
    prepare_app(3);
    task[1] = record;
    task[2] = snapshot;
    app.log = &log;
    app.keep = &keep;
    app.writing = &sm_writing;
    seen[0].stop_at = 100;
    CHECK(run_app() == SM_OK && counts_agree(0) && !pthread_equal(seen[0].thread, pthread_self()));
    CHECK(log.cursor == events.next && log.written > 1000 && log.dropped == 0 && keep.written > 0 && keep.written + keep.replaced == keep.taken);
    prepare_app(1);                                              // one executor of several still has its own thread, but no locks
    crew_vector.guarded = events.guarded = false;
    app.keep = &keep;
    app.writing = &sm_writing;
    CHECK(pal_nvm_close(keep.nvm) == SM_OK);
    seen[0].stop_at = 10;
    CHECK(run_app() == SM_OK && app.restored && crew_sv.number > 0 && !pthread_equal(seen[0].thread, pthread_self()));
    CHECK(unlink("flight") == 0 && unlink("kept") == 0 && chdir("/") == 0 && rmdir(folder) == 0);
}

// ---- refused ----

static void test_refused(void)
{
    prepare_app(PAL_THREADS + 1);
    CHECK(run_app() == SM_E_FULL && app.failed_executor == &executor[PAL_THREADS] && app.reason != NULL);
    prepare_app(PAL_THREADS);
    app.watchdog = PAL_SECOND;
    CHECK(run_app() == SM_E_FULL && app.failed_executor == NULL && app.failed_part != NULL);
    for (int i = 0; i < PAL_THREADS; i++)
        CHECK(seen[i].calls == 0);
    prepare_app(2);                                              // their threads have ended, so that new ones can start
    app.watchdog = UINT64_MAX;
    CHECK(run_app() == SM_E_ARGUMENT && seen[0].calls == 0);
    prepare_app(2);
    crew_vector.guarded = false;
    CHECK(run_app() == SM_E_ARGUMENT && seen[0].calls == 0);
}

// ---- priorities ----

static void test_priorities(void)
{
    struct sched_param fifo = {1}, plain = {0};
    const bool permitted = sched_setscheduler(0, SCHED_FIFO, &fifo) == 0;

    sched_setscheduler(0, SCHED_OTHER, &plain);
    prepare_app(3);
    executor[1].priority = 20;
    executor[2].priority = 30;
    app.watchdog = 10 * (uint64_t)PAL_SECOND;
    seen[2].stop_at = 10;
    CHECK(run_app() == SM_OK && all_counts_agree() && seen[0].policy == SCHED_OTHER);
    CHECK(!permitted || (seen[1].policy == SCHED_FIFO && seen[2].policy == SCHED_FIFO));
    prepare_app(1);
    executor[0].priority = 20;
    seen[0].stop_at = 10;
    CHECK(run_app() == SM_OK && (!permitted || seen[0].policy == SCHED_FIFO) && sched_getscheduler(0) == SCHED_OTHER);
}

// ---- the watchdog: the one that kills the program ----

static int child(uint16_t n, int hang)
{
    int status = -1;
    const pid_t pid = fork();

    if (pid == 0) {
        prepare_app(n);
        app.watchdog = hang >= 0 ? 300 * MS : 2000 * MS;
        seen[0].stop_at = 1000;
        if (hang >= 0)
            seen[hang].hang = true;
        run_app();
        _exit(all_counts_agree() ? 0 : 1);
    }
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid);
    return status;
}

static void test_watchdog(void)
{
    int status = child(2, -1);

    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    status = child(2, 1);
    CHECK(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    status = child(1, 0);
    CHECK(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

int main(void)
{
    test_watchdog();
    test_stop_by_task();
    test_stop_at_random();
    test_stop_at_once();
    test_stop_by_signal();
    test_stop_asleep();
    test_alone();
    test_one_thread();
    test_too_fast();
    test_written();
    test_refused();
    test_priorities();
    return test_end("app");
}
