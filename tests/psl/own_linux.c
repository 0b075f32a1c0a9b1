// SPDX-License-Identifier: Apache-2.0
// What the Linux platform promises beyond the headers: files of non-volatile memory after a cut at any moment and on a full
// disk; what signals, rights and a time of day that is set must not change; what console, analog channels and watchdog really
// do.  The system's calls come here first (ld's --wrap), so that each of them can be made to fail.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/console.h"
#include "runtime-c/pal/lock.h"
#include "runtime-c/pal/log.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/pal/socket.h"
#include "runtime-c/pal/thread.h"
#include "runtime-c/pal/watchdog.h"
#include "tests/psl/suite.h"

ssize_t __real_write(int fd, const void *from, size_t n);
int __real_fsync(int fd);
int __real_fdatasync(int fd);
int __wrap_fdatasync(int fd);
int __real_rename(const char *from, const char *to);
int __real_unlink(const char *path);
int __real_pthread_mutex_timedlock(pthread_mutex_t *mutex, const struct timespec *end);
int __real_timer_settime(timer_t timer, int flags, const struct itimerspec *to, struct itimerspec *old);
int __wrap_timer_settime(timer_t timer, int flags, const struct itimerspec *to, struct itimerspec *old);
int __real_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *timeout, const sigset_t *mask);
int __wrap_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *timeout, const sigset_t *mask);
ssize_t __wrap_write(int fd, const void *from, size_t n);
int __wrap_fsync(int fd);
int __wrap_rename(const char *from, const char *to);
int __wrap_unlink(const char *path);
int __wrap_pthread_mutex_timedlock(pthread_mutex_t *mutex, const struct timespec *end);

static struct {
    bool watching;            // whether a test looks at the calls
    int left;                 // calls that still work; below 0: all
    int error;                // what the next one fails with
    bool for_good;            // and all after it: the power is gone
    char log[64];             // a letter for each call
} faults = {false, -1, 0, false, ""};

static bool fails(char letter)
{
    size_t n;

    if (!faults.watching)
        return false;
    n = strlen(faults.log);
    if (n + 1 < sizeof faults.log)
        faults.log[n] = letter, faults.log[n + 1] = '\0';
    if (faults.left < 0 || faults.left-- > 0)
        return false;
    if (faults.for_good)
        faults.left = 0;
    errno = faults.error;
    return true;
}

// Half of what is to be written, then nothing: as a disk that fills up.
ssize_t __wrap_write(int fd, const void *from, size_t n)
{
    if (!fails('w'))
        return __real_write(fd, from, n);
    if (n > 1)
        (void)!__real_write(fd, from, n / 2);
    return -1;
}

int __wrap_fsync(int fd) { return fails('f') ? -1 : __real_fsync(fd); }
int __wrap_fdatasync(int fd) { return fails('d') ? -1 : __real_fdatasync(fd); }
int __wrap_rename(const char *from, const char *to) { return fails('r') ? -1 : __real_rename(from, to); }
int __wrap_unlink(const char *path) { return fails('u') ? -1 : __real_unlink(path); }

// As if the time of day were set beyond `end` while it waits.
int __wrap_pthread_mutex_timedlock(pthread_mutex_t *mutex, const struct timespec *end)
{
    return fails('l') ? ETIMEDOUT : __real_pthread_mutex_timedlock(mutex, end);
}

int __wrap_timer_settime(timer_t timer, int flags, const struct itimerspec *to, struct itimerspec *old)
{
    return fails('t') ? -1 : __real_timer_settime(timer, flags, to, old);
}

int __wrap_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *timeout, const sigset_t *mask)
{
    return fails('p') ? -1 : __real_ppoll(fds, n, timeout, mask);
}

static void fault(int left, int error, bool for_good)
{
    faults.watching = true;
    faults.left = left;
    faults.error = error;
    faults.for_good = for_good;
    faults.log[0] = '\0';
}

static void no_fault(void)
{
    faults.watching = false;
}

// ---- non-volatile memory ----

#define SIZE 1200u            // three blocks of the copy: no power of two, no multiple

static char memory_name[64];

static PalNvm reopened(void)
{
    PalNvm memory = {0};

    CHECK(pal_nvm_open(&memory, memory_name, SIZE) == SM_OK);
    return memory;
}

static void fill(PalNvm memory, uint8_t value)
{
    uint8_t bytes[SIZE];

    memset(bytes, value, SIZE);
    CHECK(pal_nvm_write(memory, 0, bytes, SIZE) == SM_OK);
}

// The value of all bytes, or -1 if they are not the same.
static int value_of(PalNvm memory)
{
    uint8_t bytes[SIZE];

    memset(bytes, 0, SIZE);
    CHECK(pal_nvm_read(memory, 0, bytes, SIZE) == SM_OK);
    for (uint32_t i = 1; i < SIZE; i++)
        if (bytes[i] != bytes[0])
            return -1;
    return bytes[0];
}

// The new file is on the medium before it gets the name, and the name before the call returns.
static void in_this_order(void)
{
    PalNvm memory = reopened();

    fault(-1, 0, false);
    fill(memory, 3);
    no_fault();
    CHECK(strcmp(faults.log, "wwwfrf") == 0);
    CHECK(pal_nvm_close(memory) == SM_OK);
}

// Cuts the power before each call in turn; when it is back, all is old or all is new.
static void cut_anywhere(void)
{
    const uint8_t bytes[SIZE] = {0};
    bool done = false, was_old = false, was_new = false;

    for (int calls = 0; calls < 20 && !done; calls++) {
        PalNvm memory = reopened();
        int value;

        fill(memory, 1);
        fault(calls, EIO, true);
        done = pal_nvm_write(memory, 0, bytes, SIZE) == SM_OK;
        no_fault();
        CHECK(pal_nvm_close(memory) == SM_OK);
        memory = reopened();
        value = value_of(memory);
        CHECK(value == (done ? 0 : 1) || value == 0);
        was_old = was_old || value == 1;
        was_new = was_new || (value == 0 && !done);
        CHECK(pal_nvm_close(memory) == SM_OK);
    }
    CHECK(done && was_old && was_new);
}

// A write that fails leaves the memory usable and nothing lying about.
static void full_disk(void)
{
    PalNvm memory = reopened();
    const uint8_t bytes[SIZE] = {0};
    char name[80];

    snprintf(name, sizeof name, "%s.new", memory_name);
    fill(memory, 1);
    for (int calls = 0; calls < 3; calls++) {
        fault(calls, ENOSPC, false);
        CHECK(pal_nvm_write(memory, 0, bytes, SIZE) == SM_E_SPACE);
        CHECK(strchr(faults.log, 'u') != NULL);
        no_fault();
        CHECK(value_of(memory) == 1);
        CHECK(access(name, F_OK) != 0);
    }
    fill(memory, 2);
    CHECK(value_of(memory) == 2);
    CHECK(pal_nvm_close(memory) == SM_OK);
}

static void size_on_disk(off_t expected)
{
    struct stat s;

    CHECK(stat(memory_name, &s) == 0 && s.st_size == expected);
}

static void lengthens(void)
{
    PalNvm memory = {0};
    uint8_t x = 5, two[2] = {0, 0};

    CHECK(__real_unlink(memory_name) == 0);
    CHECK(pal_nvm_open(&memory, memory_name, 1) == SM_OK);
    CHECK(pal_nvm_write(memory, 0, &x, 1) == SM_OK);
    CHECK(pal_nvm_close(memory) == SM_OK);
    size_on_disk(1);
    CHECK(pal_nvm_open(&memory, memory_name, 1000) == SM_OK);
    CHECK(pal_nvm_read(memory, 0, two, 2) == SM_OK && two[0] == 5 && two[1] == 0xff);
    CHECK(pal_nvm_close(memory) == SM_OK);
    size_on_disk(1000);
    CHECK(pal_nvm_open(&memory, memory_name, 10) == SM_OK);       // and never shortens
    CHECK(pal_nvm_read(memory, 999, two, 1) == SM_OK);
    CHECK(pal_nvm_close(memory) == SM_OK);
    size_on_disk(1000);
}

static void no_file(void)
{
    PalNvm memory = {0};

    CHECK(pal_nvm_open(&memory, ".", 1) == SM_E_UNSUPPORTED);
    CHECK(mkfifo("pipe", 0600) == 0 && symlink(memory_name, "link") == 0);
    CHECK(pal_nvm_open(&memory, "pipe", 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_open(&memory, "link", 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_open(&memory, "pipe/x", 1) == SM_E_MISSING);
    CHECK(__real_unlink("pipe") == 0 && __real_unlink("link") == 0);
    for (int i = 0; i < 2 * PAL_NVMS; i++)                // failing leaves no entry taken
        CHECK(pal_nvm_open(&memory, ".", 1) == SM_E_UNSUPPORTED);
}

static void no_line(void)
{
    PalSerial line = {0};

    CHECK(pal_serial_open(&line, memory_name, 9600) == SM_E_UNSUPPORTED && line.id == 0);
}

static void nvm(void)
{
    snprintf(memory_name, sizeof memory_name, "%s.own", bench.nvm_name);
    in_this_order();
    cut_anywhere();
    full_disk();
    lengthens();
    no_file();
    no_line();
    unlink(memory_name);
}

// ---- logs ----

#define LOG_NAME "own.log"

static PalLogFile log_opened(void)
{
    PalLogFile file = {0};

    CHECK(pal_log_open(&file, LOG_NAME) == SM_OK);
    return file;
}

// A new file's name is on the medium when open returns; bytes go on from where they stopped; only sync waits.
static void log_order(void)
{
    PalLogFile file;

    fault(-1, 0, false);
    file = log_opened();
    CHECK(pal_log_append(file, "abcd", 4) == SM_OK && pal_log_sync(file) == SM_OK);
    CHECK(pal_log_close(file) == SM_OK);
    file = log_opened();
    CHECK(pal_log_close(file) == SM_OK);
    no_fault();
    CHECK(strcmp(faults.log, "fwd") == 0);
}

static void log_full(void)
{
    PalLogFile file = log_opened();
    uint64_t size = 0;

    fault(0, ENOSPC, false);
    CHECK(pal_log_append(file, "efgh", 4) == SM_E_SPACE);
    no_fault();
    CHECK(pal_log_size(file, &size) == SM_OK && size == 6);
    fault(0, EINTR, false);
    CHECK(pal_log_append(file, "gh", 2) == SM_OK);
    fault(0, EINTR, false);
    CHECK(pal_log_sync(file) == SM_OK);
    fault(0, EIO, false);
    CHECK(pal_log_sync(file) == SM_E_DEVICE);
    no_fault();
    CHECK(pal_log_close(file) == SM_OK);
}

static void no_log(void)
{
    PalLogFile file = {0};

    CHECK(mkfifo("pipe", 0600) == 0 && symlink(LOG_NAME, "link") == 0);
    CHECK(pal_log_open(&file, ".") == SM_E_UNSUPPORTED);
    CHECK(pal_log_open(&file, "pipe") == SM_E_UNSUPPORTED);
    CHECK(pal_log_open(&file, "pipe/x") == SM_E_MISSING);
    CHECK(pal_log_open(&file, "/dev/null") == SM_E_UNSUPPORTED);
    CHECK(file.id == 0);
    CHECK(pal_log_open(&file, "link") == SM_OK && pal_log_close(file) == SM_OK);      // a log may be a link
    fault(0, EIO, false);
    CHECK(pal_log_open(&file, "new.log") == SM_E_DEVICE);
    no_fault();
    CHECK(__real_unlink("pipe") == 0 && __real_unlink("link") == 0 && __real_unlink(LOG_NAME) == 0 && __real_unlink("new.log") == 0);
}

// ---- time ----

static void on_alarm(int number)
{
    (void)number;
}

// Signals come all the time: sleeps and waits are as long as ever.
static void signals(void)
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

// Who waits leaves the processor to others: the system is asked once, or again after a signal, and not all the time.
static void waiting_is_free(void)
{
    const PalAddress here = {{127, 0, 0, 1}, 0};
    PalSocket s = {0};
    uint8_t x;
    size_t n;

    CHECK(pal_socket_udp(&s, &here) == SM_OK);
    fault(-1, 0, false);
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 50 * MS) == SM_E_TIMEOUT);
    no_fault();
    CHECK(strlen(faults.log) <= 3);
    CHECK(pal_socket_close(s) == SM_OK);
}

static void hold(void *lock)
{
    pal_lock_take(*(PalLock *)lock, PAL_SECOND);
    pal_clock_sleep_until(pal_clock_now() + 20 * MS);
    pal_lock_give(*(PalLock *)lock);
}

// A lock is waited for by the monotonic clock, whatever happens to the time of day.
static void time_is_set(void)
{
    const PalThreadPlan plan = {NULL, 0, 0};
    PalThread thread = {0};
    PalLock lock = {0};

    CHECK(pal_lock_open(&lock) == SM_OK);
    CHECK(pal_thread_create(&thread, &plan, hold, &lock) == SM_OK);
    pal_clock_sleep_until(pal_clock_now() + 5 * MS);
    fault(0, 0, false);
    CHECK(pal_lock_take(lock, 20 * (uint64_t)PAL_SECOND) == SM_OK);
    no_fault();
    CHECK(pal_lock_give(lock) == SM_OK);
    CHECK(pal_thread_join(thread, PAL_SECOND) == SM_OK);
    CHECK(pal_lock_close(lock) == SM_OK);
}

// ---- priorities ----

static void nothing(void *argument)
{
    (void)argument;
}

// 0 if everything is as it should be for somebody who may not have a real-time priority.
static int without_rights(void)
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

static void priorities(void)
{
    int status = 0;
    pid_t pid;

    if (geteuid() != 0)                                   // then the contract has shown it
        return;
    fflush(NULL);
    pid = fork();
    if (pid == 0)
        _exit(without_rights());
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid && status == 0);
}

static uint64_t processor_time(void)
{
    struct timespec t = {0, 0};

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (uint64_t)t.tv_sec * PAL_SECOND + (uint64_t)t.tv_nsec;
}

// Three threads on one processor: a low one holds the lock and has work to do, a high one wants it, a middle one keeps the
// processor busy.  Without inheritance the middle one would keep the low one, and so the high one, waiting.
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

// With the highest priority of all, so that the order of the beginning is ours.
static void invert(Inversion *v)
{
    const PalThreadPlan plans[] = {{"low", 1, 0}, {"high", 10, 0}, {"middle", 5, 0}};
    PalThreadMain *const mains[] = {low, high, middle};
    PalThread threads[3];

    for (size_t i = 0; i < COUNT(threads); i++) {
        CHECK(pal_thread_create(&threads[i], &plans[i], mains[i], v) == SM_OK && pal_thread_is_realtime(threads[i]));
        if (i == 0)
            pal_clock_sleep_until(pal_clock_now() + 2 * MS);       // until it holds the lock
    }
    for (size_t i = 0; i < COUNT(threads); i++)
        CHECK(pal_thread_join(threads[i], 10 * (uint64_t)PAL_SECOND) == SM_OK);
}

static void inheritance(void)
{
    Inversion v = {{0}, false, false, false};
    cpu_set_t all, one;

    if (pal_thread_set_priority(20) != SM_OK)              // not permitted here
        return;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    CHECK(pal_lock_open(&v.lock) == SM_OK);
    CHECK(sched_getaffinity(0, sizeof all, &all) == 0 && sched_setaffinity(0, sizeof one, &one) == 0);
    invert(&v);
    CHECK(sched_setaffinity(0, sizeof all, &all) == 0);
    CHECK(pal_thread_set_priority(0) == SM_OK);
    CHECK(!v.high_waited_for_middle);
    CHECK(pal_lock_close(v.lock) == SM_OK);
}

// ---- the console ----

// As read, but for all of n: a terminal may hand over what was written in pieces.
static bool read_all(int fd, char *to, size_t n)
{
    ssize_t got = 1;

    for (; n > 0 && got > 0; n -= (size_t)got, to += got)
        got = read(fd, to, n);
    return n == 0;
}

// With `near` as standard output: what is written comes to `far`, and if nobody reads there that is not waited for.
static void console_on(int near, int far)
{
    static char text[997], in[997];
    int saved = dup(STDOUT_FILENO);
    SmResult r = SM_OK;
    size_t calls = 0;

    fflush(stdout);
    memset(text, 'x', sizeof text);
    CHECK(dup2(near, STDOUT_FILENO) == STDOUT_FILENO);
    CHECK(pal_console_write(text, sizeof text) == SM_OK);
    CHECK(read_all(far, in, sizeof in) && memcmp(in, text, sizeof in) == 0);
    memset(text, '\n', sizeof text);                      // a terminal makes two bytes of it: room for one is too little
    for (; r == SM_OK && calls < 10000; calls++)
        r = pal_console_write(text, sizeof text);
    CHECK(r == SM_E_BUSY && calls > 1);
    CHECK(dup2(saved, STDOUT_FILENO) == STDOUT_FILENO);
    CHECK(close(saved) == 0 && close(near) == 0 && close(far) == 0);
}

static void console(void)
{
    int ends[2], terminal = posix_openpt(O_RDWR | O_NOCTTY);
    char name[64];

    CHECK(pipe(ends) == 0);
    console_on(ends[1], ends[0]);
    CHECK(grantpt(terminal) == 0 && unlockpt(terminal) == 0 && ptsname_r(terminal, name, sizeof name) == 0);
    console_on(open(name, O_RDWR | O_NOCTTY), terminal);
}

// ---- analog ----

static void put_value(const char *kind, const char *text)
{
    char name[64];
    FILE *f;

    snprintf(name, sizeof name, "iio/iio:device3/%s", kind);
    f = fopen(name, "w");
    CHECK(f != NULL && fputs(text, f) >= 0 && fclose(f) == 0);
}

// What channel 3007 measures with these files: raw value, offset and scale, NULL for one that is not there.
static int32_t measured(const char *raw, const char *offset, const char *scale)
{
    PalAio channel = {0};
    int32_t x = -1;

    put_value("in_current7_raw", raw);
    if (offset)
        put_value("in_current_offset", offset);
    if (scale)
        put_value("in_current7_scale", scale);
    CHECK(pal_aio_open(&channel, 3007, PAL_AIO_INPUT) == SM_OK);
    if (pal_aio_read(channel, &x) == SM_E_DEVICE)
        x = -2;
    CHECK(pal_aio_close(channel) == SM_OK);
    return x;
}

static void aio(void)
{
    CHECK(mkdir("iio/iio:device3", 0700) == 0);
    CHECK(measured("12\n", NULL, NULL) == 12000);         // millionths of what the kernel gives in thousandths
    CHECK(measured("2048\n", NULL, "1.220703125\n") == 2500000);
    CHECK(measured("-4\n", NULL, "0.001\n") == -4);
    CHECK(measured("100\n", "-40.5\n", "2\n") == 119000);
    CHECK(measured("99999999\n", "0\n", "1\n") == INT32_MAX);
    CHECK(measured("-99999999\n", "0\n", "1\n") == INT32_MIN);
    CHECK(measured("", "0\n", "1\n") == -2);
    CHECK(measured("nothing\n", "0\n", "1\n") == -2);
    __real_unlink("iio/iio:device3/in_current7_raw");
    __real_unlink("iio/iio:device3/in_current_offset");
    __real_unlink("iio/iio:device3/in_current7_scale");
    CHECK(rmdir("iio/iio:device3") == 0);
}

// ---- the watchdog ----

static void child(uint64_t period)
{
    uint64_t actual;

    if (pal_watchdog_start(period, &actual) != SM_OK)
        _exit(1);
    for (int i = 0; i < 3; i++) {
        pal_clock_sleep_until(pal_clock_now() + 10 * MS);
        pal_watchdog_feed();
    }
    if (period < PAL_SECOND)
        pal_clock_sleep_until(pal_clock_now() + 20 * (uint64_t)PAL_SECOND);
    _exit(0);
}

// The signal that ended a program with such a watchdog, or 0.
static int end_of(uint64_t period)
{
    int status = 0;
    pid_t pid;

    fflush(NULL);
    pid = fork();
    if (pid == 0)
        child(period);
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

// Starting and each feeding set the timer anew.
static void feeding(void)
{
    uint64_t actual;

    fault(-1, 0, false);
    CHECK(pal_watchdog_start(PAL_TIMEOUT_MAX, &actual) == SM_OK && actual == PAL_TIMEOUT_MAX);
    CHECK(pal_watchdog_feed() == SM_OK && pal_watchdog_feed() == SM_OK);
    CHECK(strcmp(faults.log, "ttt") == 0);
    fault(0, EINVAL, false);
    CHECK(pal_watchdog_feed() == SM_E_DEVICE);
    no_fault();
    CHECK(pal_watchdog_stop() == SM_OK);
}

static void watchdog(void)
{
    feeding();
    CHECK(end_of(100 * MS) == SIGKILL);
    CHECK(end_of(PAL_TIMEOUT_MAX) == 0);
}

Tally own_linux(void)
{
    nvm();
    log_order();
    log_full();
    no_log();
    signals();
    waiting_is_free();
    time_is_set();
    priorities();
    inheritance();
    console();
    aio();
    watchdog();
    return TALLY();
}
