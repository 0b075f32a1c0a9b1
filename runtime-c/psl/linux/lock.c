// SPDX-License-Identifier: Apache-2.0
// Locks: a word that contains the thread id of its holder, or 0 while it is free.  Taking a free lock, and releasing one without
// waiters, is one atomic exchange.  With contention, the kernel queues the waiters and lends their priority to the holder
// (futex(2), "priority-inheritance futexes").
#define _GNU_SOURCE
#include <errno.h>
#include <linux/futex.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "runtime-c/pal/lock.h"
#include "runtime-c/psl/linux/linux.h"

#ifndef FUTEX_LOCK_PI2
#define FUTEX_LOCK_PI2 13         // since Linux 5.14; older headers lack it
#endif

static bool used[PAL_LOCKS];
static uint32_t lock_words[PAL_LOCKS];
static __thread uint32_t own_id;  // the caller's thread id; 0: not yet requested

// Called in a child process after fork.
static void forget_own_id(void)
{
    own_id = 0;
}

// Makes child processes clear own_id: a child has another thread id than the thread that forked it.
static void register_fork_handler(void)
{
    pthread_atfork(NULL, NULL, forget_own_id);
}

// Asks the kernel for the caller's thread id and stores it in own_id.
__attribute__((noinline)) static uint32_t request_thread_id(void)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;

    pthread_once(&once, register_fork_handler);
    return own_id = (uint32_t)syscall(SYS_gettid);
}

// Returns the caller's thread id, which the kernel must be asked for only once.
static uint32_t thread_id(void)
{
    return own_id ? own_id : request_thread_id();
}

// Returns the thread id in the word of a lock; 0: no thread holds it.
static uint32_t read_holder(uint32_t *word)
{
    return __atomic_load_n(word, __ATOMIC_ACQUIRE) & FUTEX_TID_MASK;
}

// Takes the lock if it is free.  Returns whether it was.
static bool try_acquire(uint32_t *word)
{
    uint32_t unheld = 0;

    return __atomic_compare_exchange_n(word, &unheld, thread_id(), false, __ATOMIC_ACQUIRE, __ATOMIC_RELAXED);
}

// Releases the lock if no thread waits for it.  Otherwise returns false: the kernel must release it.
static bool try_release(uint32_t *word)
{
    uint32_t held_without_waiters = thread_id();

    return __atomic_compare_exchange_n(word, &held_without_waiters, 0, false, __ATOMIC_RELEASE, __ATOMIC_RELAXED);
}

// Calls futex(2) and returns 0 or an errno.
static int futex(uint32_t *word, int operation, const struct timespec *end)
{
    return syscall(SYS_futex, word, operation | FUTEX_PRIVATE_FLAG, 0, end, NULL, 0) == 0 ? 0 : errno;
}

SmResult pal_lock_open(PalLock *lock)
{
    if (!lock)
        return SM_E_ARGUMENT;
    lock->id = psl_allocate(used, PAL_LOCKS);
    return lock->id == 0 ? SM_E_FULL : SM_OK;
}

SmResult pal_lock_close(PalLock lock)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_LOCKS, lock.id)) {
        r = read_holder(&lock_words[lock.id - 1]) == 0 ? SM_OK : SM_E_BUSY;
        used[lock.id - 1] = r != SM_OK;
    }
    psl_unlock_tables();
    return r;
}

// Waits for the lock for `left` nanoseconds on a kernel before 5.14, which measures the timeout by the time of day.  That clock
// may be set during the wait, so the caller checks the monotonic clock.  Returns 0 or an errno.
static int wait_with_realtime_clock(uint32_t *word, uint64_t left)
{
    struct timespec end, more = psl_timespec(left);

    clock_gettime(CLOCK_REALTIME, &end);
    end.tv_sec += more.tv_sec + (end.tv_nsec + more.tv_nsec) / (long)PAL_SECOND;
    end.tv_nsec = (end.tv_nsec + more.tv_nsec) % (long)PAL_SECOND;
    return futex(word, FUTEX_LOCK_PI, &end);
}

// Waits until the kernel passes the lock to the caller.  A holder whose thread has ended (ESRCH) never releases the lock,
// which is a timeout.  If a signal interrupts the wait at the deadline, the error stays EINTR, which also means timeout.
static SmResult wait_for_lock(uint32_t *word, uint64_t deadline)
{
    const struct timespec end = psl_timespec(deadline);
    uint64_t now;
    int error;

    do {
        now = pal_clock_now();
        error = futex(word, FUTEX_LOCK_PI2, &end);
        if (error == ENOSYS)
            error = wait_with_realtime_clock(word, now < deadline ? deadline - now : 0);
    } while ((error == ETIMEDOUT || error == EAGAIN || error == EINTR) && now < deadline);
    (void)read_holder(word);                              // acquire: makes the writes of the last holder visible
    return error == ESRCH || error == EINTR ? SM_E_TIMEOUT : psl_result_of_errno(error);
}

// Waits for a lock that is held, first by spinning.  Not inlined, because its register use would slow down taking a free lock.
__attribute__((noinline)) static SmResult acquire_held(uint32_t *word, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;

    if (read_holder(word) == thread_id())
        return SM_E_BUSY;
    for (int i = 1; i < PAL_LOCK_SPINS; i++)
        if (try_acquire(word))
            return SM_OK;
    return timeout == 0 ? SM_E_TIMEOUT : wait_for_lock(word, deadline);
}

// In the usual case the lock is free, and the clock is not read.
SmResult pal_lock_take(PalLock lock, uint64_t timeout)
{
    if (timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    return try_acquire(&lock_words[lock.id - 1]) ? SM_OK : acquire_held(&lock_words[lock.id - 1], timeout);
}

// Lets the kernel pass the lock to a waiter.  The atomic OR changes nothing: it shows the release to the thread sanitizer, which
// does not see the system call.
__attribute__((noinline)) static SmResult release_to_waiter(uint32_t *word)
{
    if (read_holder(word) != thread_id())
        return SM_E_BUSY;
    __atomic_fetch_or(word, 0, __ATOMIC_RELEASE);
    return psl_result_of_errno(futex(word, FUTEX_UNLOCK_PI, NULL));
}

SmResult pal_lock_give(PalLock lock)
{
    if (!psl_table_is_used(used, PAL_LOCKS, lock.id))
        return SM_E_HANDLE;
    return try_release(&lock_words[lock.id - 1]) ? SM_OK : release_to_waiter(&lock_words[lock.id - 1]);
}
