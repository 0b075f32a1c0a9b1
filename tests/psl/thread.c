// SPDX-License-Identifier: Apache-2.0
// The guarantees of thread.h.
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/lock.h"
#include "runtime-c/pal/thread.h"
#include "tests/psl/suite.h"

#define LONG (10 * (uint64_t)PAL_SECOND)

static const PalThreadPlan plain = {"plain", 0, 0};

static void store(void *of)
{
    *(int *)of = 7;
}

static void without(void)
{
    PalThread thread = {0};
    int x = 0;

    CHECK(pal_thread_create(&thread, &plain, store, &x) == SM_E_UNSUPPORTED && x == 0 && thread.id == 0);
    CHECK(pal_thread_create(NULL, NULL, NULL, NULL) == SM_E_UNSUPPORTED);
    CHECK(pal_thread_join(thread, 0) == SM_E_UNSUPPORTED);
    CHECK(!pal_thread_is_realtime(thread));
    CHECK(pal_thread_set_priority(1) == SM_E_UNSUPPORTED);
}

static void bad_arguments(void)
{
    const PalThreadPlan urgent = {NULL, PAL_PRIORITY_MAX + 1, 0}, wide = {NULL, 0, UINT32_MAX};
    const PalThread bad[] = {{0}, {PAL_THREADS}, {PAL_THREADS + 1}, {255}};
    PalThread thread = {0};
    int x = 0;

    CHECK(pal_thread_create(NULL, &plain, store, &x) == SM_E_ARGUMENT);
    CHECK(pal_thread_create(&thread, NULL, store, &x) == SM_E_ARGUMENT);
    CHECK(pal_thread_create(&thread, &plain, NULL, &x) == SM_E_ARGUMENT);
    CHECK(pal_thread_create(&thread, &urgent, store, &x) == SM_E_ARGUMENT);
    CHECK(pal_thread_create(&thread, &wide, store, &x) == SM_E_ARGUMENT);
    CHECK(x == 0 && thread.id == 0);
    CHECK(pal_thread_set_priority(PAL_PRIORITY_MAX + 1) == SM_E_ARGUMENT);
    for (size_t i = 0; i < COUNT(bad); i++) {
        CHECK(pal_thread_join(bad[i], 0) == SM_E_HANDLE);
        CHECK(!pal_thread_is_realtime(bad[i]));
    }
}

static void runs(const PalThreadPlan *plan)
{
    PalThread thread = {0};
    int x = 0;

    CHECK(pal_thread_create(&thread, plan, store, &x) == SM_OK && thread.id != 0);
    if (plan->priority == 0)
        CHECK(!pal_thread_is_realtime(thread));
    CHECK(pal_thread_join(thread, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_thread_join(thread, LONG) == SM_OK);
    CHECK(x == 7);
    CHECK(pal_thread_join(thread, 0) == SM_E_HANDLE);
    CHECK(!pal_thread_is_realtime(thread));
}

// ---- a thread that runs until it is stopped ----

typedef struct Loop {
    PalLock lock;
    bool stop;
    PalThread self;
    SmResult joined;          // the result of joining itself
} Loop;

static bool is_stopped(Loop *l)
{
    bool stop;

    pal_lock_take(l->lock, PAL_SECOND);
    stop = l->stop;
    pal_lock_give(l->lock);
    return stop;
}

static void set_stop(Loop *l, bool to)
{
    pal_lock_take(l->lock, PAL_SECOND);
    l->stop = to;
    pal_lock_give(l->lock);
}

static void loop(void *of)
{
    Loop *l = of;

    while (!is_stopped(l))
        pal_clock_sleep_until(pal_clock_now() + MS);
    if (l->self.id == 0)
        return;
    pal_lock_take(l->lock, PAL_SECOND);
    l->joined = pal_thread_join(l->self, 0);
    pal_lock_give(l->lock);
    while (is_stopped(l))                                  // until another thread has checked it
        pal_clock_sleep_until(pal_clock_now() + MS);
}

// Lets the thread join itself while no other thread does.
static void join_itself(Loop *l, PalThread thread)
{
    SmResult joined = SM_OK;

    pal_lock_take(l->lock, PAL_SECOND);
    l->self = thread;
    l->stop = true;
    pal_lock_give(l->lock);
    while (joined == SM_OK) {
        pal_clock_sleep_until(pal_clock_now() + MS);
        pal_lock_take(l->lock, PAL_SECOND);
        joined = l->joined;
        pal_lock_give(l->lock);
    }
    CHECK(joined == SM_E_BUSY);
    set_stop(l, false);
}

static void join_waits(void)
{
    Loop l = {{0}, false, {0}, SM_OK};
    PalThread thread = {0};
    uint64_t before;

    CHECK(pal_lock_open(&l.lock) == SM_OK);
    CHECK(pal_thread_create(&thread, &plain, loop, &l) == SM_OK);
    CHECK(pal_thread_join(thread, 0) == SM_E_TIMEOUT);
    before = pal_clock_now();
    CHECK(pal_thread_join(thread, 5 * MS) == SM_E_TIMEOUT);
    CHECK(pal_clock_now() - before >= 5 * MS);
    join_itself(&l, thread);
    CHECK(pal_thread_join(thread, LONG) == SM_OK);
    CHECK(pal_lock_close(l.lock) == SM_OK);
}

static void table_is_full(void)
{
    Loop l = {{0}, false, {0}, SM_OK};
    PalThread threads[PAL_THREADS], more = {0};

    CHECK(pal_lock_open(&l.lock) == SM_OK);
    for (int i = 0; i < PAL_THREADS; i++)
        CHECK(pal_thread_create(&threads[i], &plain, loop, &l) == SM_OK);
    CHECK(pal_thread_create(&more, &plain, loop, &l) == SM_E_FULL && more.id == 0);
    set_stop(&l, true);
    for (int i = 0; i < PAL_THREADS; i++)
        CHECK(pal_thread_join(threads[i], LONG) == SM_OK);
    CHECK(pal_thread_create(&more, &plain, loop, &l) == SM_OK);
    CHECK(pal_thread_join(more, LONG) == SM_OK);
    CHECK(pal_lock_close(l.lock) == SM_OK);
}

// A thread gets a real-time priority if and only if the process has the right to it.
static void real_time(void)
{
    const PalThreadPlan plan = {"urgent, and with a name longer than 15 bytes", 10, 100000};
    bool may = pal_thread_set_priority(10) == SM_OK;
    PalThread thread = {0};
    int x = 0;

    if (may)
        CHECK(pal_thread_set_priority(0) == SM_OK);
    else
        CHECK(pal_thread_set_priority(10) == SM_E_DENIED);
    CHECK(pal_thread_create(&thread, &plan, store, &x) == SM_OK);
    CHECK(pal_thread_is_realtime(thread) == may);
    CHECK(pal_thread_join(thread, LONG) == SM_OK && x == 7);
}

Tally contract_thread(void)
{
    const PalThreadPlan small = {NULL, 0, 1};

    if (bench.threads == HAS_NONE) {
        without();
        return TALLY();
    }
    bad_arguments();
    runs(&plain);
    runs(&small);
    join_waits();
    table_is_full();
    real_time();
    return TALLY();
}
