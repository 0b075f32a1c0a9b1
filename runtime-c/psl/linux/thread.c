// SPDX-License-Identifier: Apache-2.0
// Threads: SCHED_FIFO if permitted (root, CAP_SYS_NICE or an rtprio limit), otherwise ordinary scheduling.  Stacks have a guard
// page, so that an overflow ends the program instead of overwriting adjacent memory.
#define _GNU_SOURCE
#include <alloca.h>
#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <sched.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "runtime-c/pal/thread.h"
#include "runtime-c/psl/linux/linux.h"

#define STACK_MAX 0x40000000u

typedef struct ThreadEntry {
    pthread_t thread;
    PalThreadMain *run;
    void *argument;
    bool realtime, joining, ended;
    size_t prefault;          // stack size in bytes of a real-time thread; 0 for others
} ThreadEntry;

static bool used[PAL_THREADS];
static ThreadEntry entries[PAL_THREADS];

// The mutex protects the table and the changing fields of its entries.  `changed` is signalled when a thread ends.
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed;
static pthread_once_t once = PTHREAD_ONCE_INIT;

// Initialises the condition variable, on which joining threads wait, with the clock of the PAL.
static void init_condition(void)
{
    pthread_condattr_t kind;

    pthread_condattr_init(&kind);
    pthread_condattr_setclock(&kind, CLOCK_MONOTONIC);
    pthread_cond_init(&changed, &kind);
    pthread_condattr_destroy(&kind);
}

// Prevents page faults in a real-time thread: touches most of its stack, and locks the program's present memory if permitted.
// (Memory allocated later is not locked: beyond a limit, the allocation would fail.)
static void prefault_stack(size_t stack)
{
    const size_t page = 4096, n = stack / 4 * 3;
    volatile char *room = alloca(n);

    for (size_t i = 0; i < n; i += page)
        room[i] = 0;
    (void)mlockall(MCL_CURRENT);
}

// The function of every thread: runs the function of the plan, then records that it has ended.
static void *thread_main(void *of)
{
    ThreadEntry *e = of;

    if (e->prefault > 0)
        prefault_stack(e->prefault);
    e->run(e->argument);
    pthread_mutex_lock(&mutex);
    e->ended = true;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&mutex);
    return NULL;
}

// Returns the stack size in bytes for a wanted size (0: PAL_THREAD_STACK): at least the system's minimum, in whole pages.
static size_t stack_size(uint32_t wanted)
{
    size_t page = (size_t)sysconf(_SC_PAGESIZE), least = (size_t)PTHREAD_STACK_MIN, n = wanted ? wanted : PAL_THREAD_STACK;

    return ((n > least ? n : least) + page - 1) / page * page;
}

// Starts a thread, with its real-time priority or without one.  Returns 0 or an errno.
static int start_thread(ThreadEntry *e, const PalThreadPlan *plan, bool realtime)
{
    pthread_attr_t a;
    struct sched_param p = {0};
    int error = pthread_attr_init(&a);

    if (error)
        return error;
    p.sched_priority = realtime ? plan->priority : 0;
    pthread_attr_setinheritsched(&a, PTHREAD_EXPLICIT_SCHED);
    pthread_attr_setschedpolicy(&a, realtime ? SCHED_FIFO : SCHED_OTHER);
    pthread_attr_setschedparam(&a, &p);
    e->prefault = realtime ? stack_size(plan->stack) : 0;
    error = pthread_attr_setstacksize(&a, stack_size(plan->stack));
    if (!error)
        error = pthread_create(&e->thread, &a, thread_main, e);
    pthread_attr_destroy(&a);
    e->realtime = realtime && !error;
    return error;
}

static void name_thread(pthread_t thread, const char *text)
{
    char short_name[16] = "";

    if (text) {
        strncat(short_name, text, sizeof short_name - 1);
        pthread_setname_np(thread, short_name);
    }
}

// Starts the thread of an entry.  Called with the mutex held, so that the creator and the joiner never see a partial entry.
static SmResult create_thread(ThreadEntry *e, const PalThreadPlan *plan)
{
    int error = start_thread(e, plan, plan->priority > 0);

    if (error == EPERM)
        error = start_thread(e, plan, false);
    if (error)
        return error == EAGAIN ? SM_E_MEMORY : psl_result_of_errno(error);
    name_thread(e->thread, plan->name);
    return SM_OK;
}

SmResult pal_thread_create(PalThread *thread, const PalThreadPlan *plan, PalThreadMain *function, void *argument)
{
    SmResult r = SM_E_FULL;
    uint8_t id;

    if (!thread || !plan || !function || plan->priority > PAL_PRIORITY_MAX || plan->stack > STACK_MAX)
        return SM_E_ARGUMENT;
    pthread_once(&once, init_condition);
    pthread_mutex_lock(&mutex);
    id = psl_table_allocate(used, PAL_THREADS);
    if (id != 0) {
        ThreadEntry *e = &entries[id - 1];

        memset(e, 0, sizeof *e);
        e->run = function;
        e->argument = argument;
        r = create_thread(e, plan);
        used[id - 1] = r == SM_OK;
    }
    pthread_mutex_unlock(&mutex);
    if (r == SM_OK)
        thread->id = id;
    return r;
}

// Waits until the thread of an entry has ended.  Called with the mutex held; releases it while waiting.
static SmResult wait_for_end(ThreadEntry *e, uint64_t deadline)
{
    struct timespec end = psl_timespec(deadline);
    int error = 0;

    if (e->joining || pthread_equal(e->thread, pthread_self()))
        return SM_E_BUSY;
    e->joining = true;
    while (!e->ended && !error)
        error = pthread_cond_timedwait(&changed, &mutex, &end);
    e->joining = e->ended;
    return e->ended ? SM_OK : psl_result_of_errno(error);
}

SmResult pal_thread_join(PalThread thread, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;
    SmResult r = SM_E_HANDLE;

    if (timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    pthread_mutex_lock(&mutex);
    if (psl_table_is_used(used, PAL_THREADS, thread.id))
        r = wait_for_end(&entries[thread.id - 1], deadline);
    if (r == SM_OK) {
        pthread_mutex_unlock(&mutex);
        pthread_join(entries[thread.id - 1].thread, NULL);     // the thread has ended, so this does not wait
        pthread_mutex_lock(&mutex);
        used[thread.id - 1] = false;
    }
    pthread_mutex_unlock(&mutex);
    return r;
}

bool pal_thread_is_realtime(PalThread thread)
{
    bool is;

    pthread_mutex_lock(&mutex);
    is = psl_table_is_used(used, PAL_THREADS, thread.id) && entries[thread.id - 1].realtime;
    pthread_mutex_unlock(&mutex);
    return is;
}

SmResult pal_thread_set_priority(uint8_t priority)
{
    struct sched_param p = {0};
    SmResult r;

    if (priority > PAL_PRIORITY_MAX)
        return SM_E_ARGUMENT;
    p.sched_priority = priority;
    r = psl_result_of_errno(pthread_setschedparam(pthread_self(), priority > 0 ? SCHED_FIFO : SCHED_OTHER, &p));
    if (r == SM_OK && priority > 0)
        prefault_stack(PAL_THREAD_STACK);
    return r;
}
