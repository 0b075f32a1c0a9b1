// SPDX-License-Identifier: Apache-2.0
// Time, locks, priorities and failing writes on Linux.  Signals, missing rights and a change of the time of day must not affect them.
#define _GNU_SOURCE
#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/console.h"
#include "runtime-c/pal/lock.h"
#include "runtime-c/pal/log.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/pal/socket.h"
#include "runtime-c/pal/thread.h"
#include "tests/psl/own_faults_linux.h"
#include "tests/psl/suite.h"

// ---- time ----

static void on_alarm(int number)
{
    (void)number;
}

// Signals arrive repeatedly: sleeps and waits last as long as without them.
static void test_signals(void)
{
    const struct itimerval often = {{0, 1000}, {0, 1000}}, never = {{0, 0}, {0, 0}};
    const PalAddress here = {{127, 0, 0, 1}, 0};
    PalSocket s = {0};
    uint64_t before;
    uint8_t x;
    size_t n;

    CHECK(pal_socket_udp(&s, &here) == SM_OK);
    CHECK(signal(SIGALRM, on_alarm) != SIG_ERR && setitimer(ITIMER_REAL, &often, NULL) == 0);
    before = pal_clock_now();
    CHECK(pal_clock_sleep_until(before + 20 * MS) == SM_OK && pal_clock_now() >= before + 20 * MS);
    before = pal_clock_now();
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 20 * MS) == SM_E_TIMEOUT && pal_clock_now() >= before + 20 * MS);
    CHECK(setitimer(ITIMER_REAL, &never, NULL) == 0);
    CHECK(pal_socket_close(s) == SM_OK);
}

// A waiting thread calls the kernel once, and again after a signal, but does not poll.
static void test_waiting_uses_no_processor(void)
{
    const PalAddress here = {{127, 0, 0, 1}, 0};
    PalSocket s = {0};
    uint8_t x;
    size_t n;

    CHECK(pal_socket_udp(&s, &here) == SM_OK);
    fault(-1, 0, false);
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 50 * MS) == SM_E_TIMEOUT);
    no_fault();
    CHECK(strlen(calls()) <= 3);
    CHECK(pal_socket_close(s) == SM_OK);
}

static volatile sig_atomic_t handled;

static void on_signal(int number)
{
    (void)number;
    handled++;
}

static bool is_pending(int number)
{
    sigset_t pending;

    return sigpending(&pending) != 0 || sigismember(&pending, number) != 0;
}

static bool is_blocked(int number)
{
    sigset_t mask;

    return pthread_sigmask(SIG_BLOCK, NULL, &mask) != 0 || sigismember(&mask, number) != 0;
}

// Whether failing writes return their results and leave no signal pending: to the console without a reader, and to a log and a memory at
// the size limit of files.
static bool writes_fail(void)
{
    const uint8_t bytes[64] = {0};
    PalLogFile file = {0};
    PalNvm memory = {0};
    const struct rlimit small = {16, 16};
    bool ok = pal_console_write("x\n", 2) == SM_E_CLOSED && pal_console_write("y\n", 2) == SM_E_CLOSED;

    ok = pal_log_open(&file, "limited") == SM_OK && pal_nvm_open(&memory, "small", sizeof bytes) == SM_OK && ok;
    ok = setrlimit(RLIMIT_FSIZE, &small) == 0 && ok;
    ok = pal_log_append(file, bytes, sizeof bytes) == SM_E_SPACE && ok;
    ok = pal_nvm_write(memory, 0, bytes, sizeof bytes) == SM_E_SPACE && ok;
    return ok && handled == 0;
}

// Returns 0 if the writes fail as they must, and the program's handling of both signals, `before`, is unchanged.
static int check_with_handling(void (*before)(int), bool blocked)
{
    const int numbers[] = {SIGPIPE, SIGXFSZ};
    sigset_t both;
    int ends[2], wrong = 0;

    sigemptyset(&both);
    for (size_t i = 0; i < COUNT(numbers); i++) {
        sigaddset(&both, numbers[i]);
        wrong |= signal(numbers[i], before) == SIG_ERR;
    }
    wrong |= pthread_sigmask(blocked ? SIG_BLOCK : SIG_UNBLOCK, &both, NULL) != 0;
    wrong |= pipe(ends) != 0 || dup2(ends[1], STDOUT_FILENO) < 0 || close(ends[0]) != 0;
    wrong |= writes_fail() ? 0 : 2;
    for (size_t i = 0; i < COUNT(numbers); i++)
        if (is_pending(numbers[i]) || is_blocked(numbers[i]) != blocked || signal(numbers[i], SIG_DFL) != before)
            wrong |= 4;
    return wrong;
}

// A signal that was pending before a failing write stays pending.
static int check_with_pending(void)
{
    sigset_t one;
    int ends[2], wrong = 0;

    sigemptyset(&one);
    sigaddset(&one, SIGPIPE);
    wrong |= pthread_sigmask(SIG_BLOCK, &one, NULL) != 0 || raise(SIGPIPE) != 0;
    wrong |= pipe(ends) != 0 || dup2(ends[1], STDOUT_FILENO) < 0 || close(ends[0]) != 0;
    wrong |= pal_console_write("x\n", 2) == SM_E_CLOSED ? 0 : 2;
    return wrong | (is_pending(SIGPIPE) ? 0 : 4);
}

// A failing write does not end the program, and does not change its signal handling.
static void test_failing_writes(void)
{
    void (*const before[])(int) = {SIG_DFL, SIG_IGN, on_signal};

    for (size_t i = 0; i < 2 * COUNT(before) + 1; i++) {
        int status = 1;
        pid_t pid;

        fflush(NULL);
        pid = fork();
        if (pid == 0)
            _exit(i == 2 * COUNT(before) ? check_with_pending() : check_with_handling(before[i / 2], i % 2 != 0));
        CHECK(pid > 0 && waitpid(pid, &status, 0) == pid && status == 0);
        unlink("limited");
        unlink("small");
    }
}

// ---- errors of the network ----

// The errors that the system can report on a socket about a peer or an earlier packet (accept(2), ip(7)).
static const int of_network[] = {ENETDOWN, EPROTO, ENOPROTOOPT, EHOSTDOWN, ENONET, EHOSTUNREACH, EOPNOTSUPP, ENETUNREACH, ETIMEDOUT,
                                 ECONNABORTED, ECONNRESET, ECONNREFUSED};

// After a temporary error, a listening socket continues with the next peer and a datagram socket with the next datagram, at once if there
// is one.
static void test_temporary_errors(void)
{
    const PalAddress here = {{127, 0, 0, 1}, 0};
    PalSocket listening = {0}, s = {0}, stream = {0}, peer = {0};
    PalAddress to, at;
    uint8_t x = 0;
    size_t n = 0;

    CHECK(pal_socket_listen(&listening, &here) == SM_OK && pal_socket_local_address(listening, &to) == SM_OK);
    CHECK(pal_socket_udp(&s, &here) == SM_OK && pal_socket_local_address(s, &at) == SM_OK);
    for (size_t i = 0; i < COUNT(of_network); i++) {
        fault(0, of_network[i], false);
        CHECK(pal_socket_accept(listening, &stream, NULL, 2 * MS) == SM_E_TIMEOUT && calls()[0] == 'a');
        no_fault();
        CHECK(pal_socket_connect(&peer, &to, PAL_SECOND) == SM_OK);
        fault(0, of_network[i], false);
        CHECK(pal_socket_accept(listening, &stream, NULL, 0) == SM_OK);
        fault(0, of_network[i], false);                   // on a stream, this is the end of the connection
        CHECK(pal_socket_receive(stream, &x, 1, &n, 0) == SM_E_CLOSED && calls()[0] == 'm');
        no_fault();
        CHECK(pal_socket_close(stream) == SM_OK && pal_socket_close(peer) == SM_OK);
        fault(0, of_network[i], false);
        CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 2 * MS) == SM_E_TIMEOUT && calls()[0] == 'm');
        no_fault();
        CHECK(pal_socket_send_to(s, &at, "x", 1) == SM_OK);
        fault(0, of_network[i], false);
        CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 0) == SM_OK && n == 1);
        no_fault();
    }
    fault(0, EIO, false);
    CHECK(pal_socket_accept(listening, &stream, NULL, 0) == SM_E_DEVICE);
    fault(0, EIO, false);
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 0) == SM_E_DEVICE);
    no_fault();
    CHECK(pal_socket_close(listening) == SM_OK && pal_socket_close(s) == SM_OK);
}

// A connection that cannot be established returns SM_E_TIMEOUT if there is no answer, and SM_E_UNREACHABLE for all other errors of the network.
static void test_failing_connects(void)
{
    const PalAddress to = {{127, 0, 0, 1}, 9};
    PalSocket stream = {0};

    for (size_t i = 0; i < COUNT(of_network); i++) {
        fault(0, of_network[i], false);
        CHECK(pal_socket_connect(&stream, &to, MS) == (of_network[i] == ETIMEDOUT ? SM_E_TIMEOUT : SM_E_UNREACHABLE));
        no_fault();
    }
    CHECK(stream.id == 0);
}

// ---- locks ----

static void hold(void *lock)
{
    pal_lock_take(*(PalLock *)lock, PAL_SECOND);
    pal_clock_sleep_until(pal_clock_now() + 100 * MS);
    pal_lock_give(*(PalLock *)lock);
}

// Whatever the kernel's first answer, the wait for a lock lasts until the timeout by the monotonic clock.
static void is_waited_for(int answer)
{
    const PalThreadPlan plan = {NULL, 0, 0};
    PalThread thread = {0};
    PalLock lock = {0};

    CHECK(pal_lock_open(&lock) == SM_OK);
    CHECK(pal_thread_create(&thread, &plan, hold, &lock) == SM_OK);
    pal_clock_sleep_until(pal_clock_now() + 5 * MS);
    fault(0, answer, false);
    CHECK(pal_lock_take(lock, 20 * (uint64_t)PAL_SECOND) == SM_OK);
    no_fault();
    CHECK(pal_lock_give(lock) == SM_OK);
    CHECK(pal_thread_join(thread, PAL_SECOND) == SM_OK);
    CHECK(pal_lock_close(lock) == SM_OK);
}

// The timeout ends the wait for a lock that stays locked, whatever the kernel's last answer.
static void is_waited_for_in_vain(int answer)
{
    const PalThreadPlan plan = {NULL, 0, 0};
    PalThread thread = {0};
    PalLock lock = {0};
    uint64_t before;

    CHECK(pal_lock_open(&lock) == SM_OK);
    CHECK(pal_thread_create(&thread, &plan, hold, &lock) == SM_OK);
    pal_clock_sleep_until(pal_clock_now() + 5 * MS);
    before = pal_clock_now();
    fault(0, answer, true);
    CHECK(pal_lock_take(lock, 2 * MS) == SM_E_TIMEOUT && pal_clock_now() - before >= 2 * MS);
    no_fault();
    CHECK(pal_thread_join(thread, PAL_SECOND) == SM_OK);
    CHECK(pal_lock_close(lock) == SM_OK);
}

// Returns 0 if the child of a fork, which is another thread, does not have its parent's locks but can take free ones.
static int check_locks_of_a_child(PalLock parents, PalLock free_one)
{
    if (pal_lock_take(parents, 0) != SM_E_TIMEOUT || pal_lock_give(parents) != SM_E_BUSY)
        return 1;
    return pal_lock_take(free_one, 0) != SM_OK || pal_lock_take(free_one, 0) != SM_E_BUSY || pal_lock_give(free_one) != SM_OK ? 2 : 0;
}

static void locks_and_forks(void)
{
    PalLock locks[2] = {{0}, {0}};
    int status = 1;
    pid_t pid;

    for (size_t i = 0; i < COUNT(locks); i++)
        CHECK(pal_lock_open(&locks[i]) == SM_OK);
    CHECK(pal_lock_take(locks[0], 0) == SM_OK);
    fflush(NULL);
    pid = fork();
    if (pid == 0)
        _exit(check_locks_of_a_child(locks[0], locks[1]));
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid && status == 0);
    CHECK(pal_lock_give(locks[0]) == SM_OK);
    for (size_t i = 0; i < COUNT(locks); i++)
        CHECK(pal_lock_close(locks[i]) == SM_OK);
}

static void waiting_for_a_lock(void)
{
    is_waited_for(ETIMEDOUT);                              // too early
    is_waited_for(EAGAIN);
    is_waited_for(ENOSYS);                                 // a kernel that can only wait by the time of day
    is_waited_for_in_vain(ETIMEDOUT);
    is_waited_for_in_vain(EAGAIN);
    is_waited_for_in_vain(EINTR);
    locks_and_forks();
}

// ---- priorities ----

static void nothing(void *argument)
{
    (void)argument;
}

// Returns 0 if everything is correct for a user without the right to a real-time priority.
static int check_without_rights(void)
{
    const struct rlimit none = {0, 0};
    const PalThreadPlan plan = {NULL, 10, 0};
    PalThread thread = {0};

    if (setrlimit(RLIMIT_RTPRIO, &none) != 0 || setuid(65534) != 0)
        return 1;
    if (pal_thread_set_priority(10) != SM_E_DENIED || pal_thread_create(&thread, &plan, nothing, NULL) != SM_OK)
        return 2;
    return pal_thread_is_realtime(thread) || pal_thread_join(thread, PAL_SECOND) != SM_OK ? 3 : 0;
}

static void test_priorities(void)
{
    int status = 0;
    pid_t pid;

    if (geteuid() != 0)                                   // a user with this right: the contract test has checked it
        return;
    fflush(NULL);
    pid = fork();
    if (pid == 0)
        _exit(check_without_rights());
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid && status == 0);
}

static uint64_t processor_time(void)
{
    struct timespec t = {0, 0};

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (uint64_t)t.tv_sec * PAL_SECOND + (uint64_t)t.tv_nsec;
}

// Three threads on one processor: a low one holds the lock and has work to do, a high one waits for the lock, and a middle one uses the
// processor all the time.  Without priority inheritance, the middle one would delay the low one, and so the high one.
typedef struct Inversion {
    PalLock lock;
    bool high_has_it, middle_is_done, high_waited_for_middle;
} Inversion;

static bool get(bool *flag) { return __atomic_load_n(flag, __ATOMIC_SEQ_CST); }
static void raise_flag(bool *flag) { __atomic_store_n(flag, true, __ATOMIC_SEQ_CST); }

static void low(void *of)
{
    Inversion *v = of;
    uint64_t start;

    pal_lock_take(v->lock, PAL_SECOND);
    start = processor_time();
    while (processor_time() - start < 10 * MS) {}
    pal_lock_give(v->lock);
}

static void middle(void *of)
{
    Inversion *v = of;
    uint64_t end = pal_clock_now() + 200 * MS;

    while (!get(&v->high_has_it) && pal_clock_now() < end) {}
    raise_flag(&v->middle_is_done);
}

static void high(void *of)
{
    Inversion *v = of;

    if (pal_lock_take(v->lock, 5 * (uint64_t)PAL_SECOND) != SM_OK || get(&v->middle_is_done))
        raise_flag(&v->high_waited_for_middle);
    raise_flag(&v->high_has_it);
    pal_lock_give(v->lock);
}

// Runs with the highest priority, so that this thread determines the order in which the others begin.
static void invert_priorities(Inversion *v)
{
    const PalThreadPlan plans[] = {{"low", 1, 0}, {"high", 10, 0}, {"middle", 5, 0}};
    PalThreadMain *const mains[] = {low, high, middle};
    PalThread threads[3];

    for (size_t i = 0; i < COUNT(threads); i++) {
        CHECK(pal_thread_create(&threads[i], &plans[i], mains[i], v) == SM_OK && pal_thread_is_realtime(threads[i]));
        if (i == 0)
            pal_clock_sleep_until(pal_clock_now() + 2 * MS);       // until it has the lock
    }
    for (size_t i = 0; i < COUNT(threads); i++)
        CHECK(pal_thread_join(threads[i], 10 * (uint64_t)PAL_SECOND) == SM_OK);
}

static void test_priority_inheritance(void)
{
    Inversion v = {{0}, false, false, false};
    cpu_set_t all, one;

    if (pal_thread_set_priority(20) != SM_OK)              // not permitted here
        return;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    CHECK(pal_lock_open(&v.lock) == SM_OK);
    CHECK(sched_getaffinity(0, sizeof all, &all) == 0 && sched_setaffinity(0, sizeof one, &one) == 0);
    invert_priorities(&v);
    CHECK(sched_setaffinity(0, sizeof all, &all) == 0);
    CHECK(pal_thread_set_priority(0) == SM_OK);
    CHECK(!v.high_waited_for_middle);
    CHECK(pal_lock_close(v.lock) == SM_OK);
}

Tally own_threads_linux(void)
{
    test_signals();
    test_failing_writes();
    test_waiting_uses_no_processor();
    test_temporary_errors();
    test_failing_connects();
    waiting_for_a_lock();
    test_priorities();
    test_priority_inheritance();
    return TALLY();
}
