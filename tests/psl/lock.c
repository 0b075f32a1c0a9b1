// SPDX-License-Identifier: Apache-2.0
// The guarantees of lock.h, and with threads, mutual exclusion.
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/lock.h"
#include "runtime-c/pal/thread.h"
#include "tests/psl/suite.h"

static void without(void)
{
    PalLock lock = {0};

    CHECK(pal_lock_open(&lock) == SM_E_UNSUPPORTED && lock.id == 0);
    CHECK(pal_lock_open(NULL) == SM_E_UNSUPPORTED);
    CHECK(pal_lock_take(lock, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_lock_give(lock) == SM_E_UNSUPPORTED);
    CHECK(pal_lock_close(lock) == SM_E_UNSUPPORTED);
}

static void one_thread(void)
{
    PalLock lock = {0}, other = {0};

    CHECK(pal_lock_open(NULL) == SM_E_ARGUMENT);
    CHECK(pal_lock_open(&lock) == SM_OK && lock.id != 0);
    CHECK(pal_lock_open(&other) == SM_OK && other.id != lock.id);
    CHECK(pal_lock_give(lock) == SM_E_BUSY);
    CHECK(pal_lock_take(lock, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_lock_take(lock, 0) == SM_OK);
    CHECK(pal_lock_take(lock, 0) == SM_E_BUSY);
    CHECK(pal_lock_take(lock, PAL_SECOND) == SM_E_BUSY);
    CHECK(pal_lock_close(lock) == SM_E_BUSY);
    CHECK(pal_lock_take(other, MS) == SM_OK);             // locks are independent
    CHECK(pal_lock_give(other) == SM_OK);
    CHECK(pal_lock_give(lock) == SM_OK);
    CHECK(pal_lock_give(lock) == SM_E_BUSY);
    CHECK(pal_lock_close(lock) == SM_OK);
    CHECK(pal_lock_close(lock) == SM_E_HANDLE);
    CHECK(pal_lock_take(lock, 0) == SM_E_HANDLE);
    CHECK(pal_lock_give(lock) == SM_E_HANDLE);
    CHECK(pal_lock_close(other) == SM_OK);
}

static void bad_handles(void)
{
    const uint8_t bad[] = {0, PAL_LOCKS, PAL_LOCKS + 1, 255};

    for (size_t i = 0; i < COUNT(bad); i++) {
        PalLock lock = {bad[i]};

        CHECK(pal_lock_take(lock, 0) == SM_E_HANDLE);
        CHECK(pal_lock_give(lock) == SM_E_HANDLE);
        CHECK(pal_lock_close(lock) == SM_E_HANDLE);
    }
}

static void table_is_full(void)
{
    PalLock locks[PAL_LOCKS], more = {0};

    for (int round = 0; round < 2; round++) {              // twice: closing frees entries
        for (int i = 0; i < PAL_LOCKS; i++)
            CHECK(pal_lock_open(&locks[i]) == SM_OK);
        CHECK(pal_lock_open(&more) == SM_E_FULL && more.id == 0);
        for (int i = 0; i < PAL_LOCKS; i++)
            CHECK(pal_lock_close(locks[i]) == SM_OK);
    }
}

// ---- with threads ----

typedef struct Shared {
    PalLock lock;
    int rounds;
    uint64_t first, second;   // equal whenever the lock is free
    bool torn;
    SmResult result;
} Shared;

static void count(void *of)
{
    Shared *s = of;

    for (int i = 0; i < s->rounds; i++) {
        if (pal_lock_take(s->lock, PAL_SECOND) != SM_OK)
            continue;
        s->torn = s->torn || s->first != s->second;
        s->first++;
        s->second++;
        pal_lock_give(s->lock);
    }
}

static void keeps_apart(void)
{
    const PalThreadPlan plan = {"count", 0, 0};
    Shared s = {{0}, 5000, 0, 0, false, SM_OK};
    PalThread threads[3];

    CHECK(pal_lock_open(&s.lock) == SM_OK);
    for (size_t i = 0; i < COUNT(threads); i++)
        CHECK(pal_thread_create(&threads[i], &plan, count, &s) == SM_OK);
    for (size_t i = 0; i < COUNT(threads); i++)
        CHECK(pal_thread_join(threads[i], 60 * (uint64_t)PAL_SECOND) == SM_OK);
    CHECK(!s.torn && s.first == 15000 && s.second == 15000);
    CHECK(pal_lock_close(s.lock) == SM_OK);
}

static void try_for_a_while(void *of)
{
    Shared *s = of;

    s->first = pal_clock_now();
    s->result = pal_lock_take(s->lock, 5 * MS);
    s->second = pal_clock_now();
}

static void give_of_another(void *of)
{
    Shared *s = of;

    s->result = pal_lock_give(s->lock);
}

static SmResult on_a_thread(PalThreadMain *function, Shared *s)
{
    const PalThreadPlan plan = {NULL, 0, 0};
    PalThread thread = {0};

    CHECK(pal_thread_create(&thread, &plan, function, s) == SM_OK);
    CHECK(pal_thread_join(thread, 10 * (uint64_t)PAL_SECOND) == SM_OK);
    return s->result;
}

static void held_by_another(void)
{
    Shared s = {{0}, 0, 0, 0, false, SM_OK};

    CHECK(pal_lock_open(&s.lock) == SM_OK);
    CHECK(pal_lock_take(s.lock, 0) == SM_OK);
    CHECK(on_a_thread(try_for_a_while, &s) == SM_E_TIMEOUT);
    CHECK(s.second - s.first >= 5 * MS);
    CHECK(on_a_thread(give_of_another, &s) == SM_E_BUSY);
    CHECK(pal_lock_give(s.lock) == SM_OK);                // this thread has held it the whole time
    CHECK(pal_lock_close(s.lock) == SM_OK);
}

Tally contract_lock(void)
{
    if (bench.locks == HAS_NONE) {
        without();
        return TALLY();
    }
    one_thread();
    bad_handles();
    table_is_full();
    if (bench.threads == HAS) {
        keeps_apart();
        held_by_another();
    }
    return TALLY();
}
