// SPDX-License-Identifier: Apache-2.0
// Locks: mutexes that inherit priority and know their holder.
#define _GNU_SOURCE
#include <errno.h>
#include <pthread.h>

#include "runtime-c/pal/lock.h"
#include "runtime-c/psl/linux/linux.h"

static bool used[PAL_LOCKS];
static pthread_mutex_t mutexes[PAL_LOCKS];

static int make(pthread_mutex_t *mutex)
{
    pthread_mutexattr_t kind;
    int error = pthread_mutexattr_init(&kind);

    if (error)
        return error;
    error = pthread_mutexattr_settype(&kind, PTHREAD_MUTEX_ERRORCHECK);
    if (!error)
        error = pthread_mutexattr_setprotocol(&kind, PTHREAD_PRIO_INHERIT);
    if (!error)
        error = pthread_mutex_init(mutex, &kind);
    pthread_mutexattr_destroy(&kind);
    return error;
}

SmResult pal_lock_open(PalLock *lock)
{
    uint8_t id;
    int error = 0;

    if (!lock)
        return SM_E_ARGUMENT;
    psl_guard();
    id = psl_table_take(used, PAL_LOCKS);
    if (id != 0 && (error = make(&mutexes[id - 1])) != 0)
        used[id - 1] = false;
    psl_unguard();
    if (id == 0)
        return SM_E_FULL;
    if (error)
        return psl_result(error);
    lock->id = id;
    return SM_OK;
}

SmResult pal_lock_close(PalLock lock)
{
    SmResult r = SM_E_HANDLE;

    psl_guard();
    if (psl_table_holds(used, PAL_LOCKS, lock.id)) {
        pthread_mutex_t *mutex = &mutexes[lock.id - 1];

        r = SM_E_BUSY;
        if (pthread_mutex_trylock(mutex) == 0) {
            pthread_mutex_unlock(mutex);
            pthread_mutex_destroy(mutex);
            used[lock.id - 1] = false;
            r = SM_OK;
        }
    }
    psl_unguard();
    return r;
}

// pthread_mutex_timedlock counts on the time of day, which may be set while it waits; the loop asks our own clock.
static int wait(pthread_mutex_t *mutex, uint64_t deadline)
{
    uint64_t now;
    int error;

    do {
        struct timespec end, left;

        now = pal_clock_now();
        left = psl_timespec(now < deadline ? deadline - now : 0);
        clock_gettime(CLOCK_REALTIME, &end);
        end.tv_sec += left.tv_sec + (end.tv_nsec + left.tv_nsec) / (long)PAL_SECOND;
        end.tv_nsec = (end.tv_nsec + left.tv_nsec) % (long)PAL_SECOND;
        error = pthread_mutex_timedlock(mutex, &end);
    } while (error == ETIMEDOUT && now < deadline);
    return error;
}

// Of a mutex that somebody holds.  Not inlined: what it keeps in registers, taking a free one would have to save.
__attribute__((noinline)) static SmResult take_held(pthread_mutex_t *mutex, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;
    int error;

    for (int i = 1; i < PAL_LOCK_SPINS; i++)
        if (pthread_mutex_trylock(mutex) == 0)
            return SM_OK;
    error = wait(mutex, deadline);
    return error == EDEADLK ? SM_E_BUSY : psl_result(error);
}

// A free one is taken without a look at the clock: that is how it is nearly always.
SmResult pal_lock_take(PalLock lock, uint64_t timeout)
{
    if (timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (!psl_table_holds(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    return pthread_mutex_trylock(&mutexes[lock.id - 1]) == 0 ? SM_OK : take_held(&mutexes[lock.id - 1], timeout);
}

SmResult pal_lock_give(PalLock lock)
{
    if (!psl_table_holds(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    return pthread_mutex_unlock(&mutexes[lock.id - 1]) == 0 ? SM_OK : SM_E_BUSY;
}
