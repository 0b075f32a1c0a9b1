// SPDX-License-Identifier: Apache-2.0
// Replaces system calls by ones that a test can make fail.
#define _GNU_SOURCE
#include <errno.h>
#include <linux/futex.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "tests/psl/own_faults_linux.h"

ssize_t __real_write(int fd, const void *from, size_t n);
int __real_fsync(int fd);
int __real_fdatasync(int fd);
int __wrap_fdatasync(int fd);
int __real_rename(const char *from, const char *to);
int __real_unlink(const char *path);
long __real_syscall(long number, ...);
int __real_timer_settime(timer_t timer, int flags, const struct itimerspec *to, struct itimerspec *old);
int __wrap_timer_settime(timer_t timer, int flags, const struct itimerspec *to, struct itimerspec *old);
int __real_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *timeout, const sigset_t *mask);
int __wrap_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *timeout, const sigset_t *mask);
int __real_accept4(int fd, struct sockaddr *a, socklen_t *n, int flags);
int __wrap_accept4(int fd, struct sockaddr *a, socklen_t *n, int flags);
ssize_t __real_recvmsg(int fd, struct msghdr *m, int flags);
ssize_t __wrap_recvmsg(int fd, struct msghdr *m, int flags);
int __real_connect(int fd, const struct sockaddr *a, socklen_t n);
int __wrap_connect(int fd, const struct sockaddr *a, socklen_t n);
ssize_t __wrap_write(int fd, const void *from, size_t n);
int __wrap_fsync(int fd);
int __wrap_rename(const char *from, const char *to);
int __wrap_unlink(const char *path);
long __wrap_syscall(long number, ...);

static struct {
    bool watching;            // a test checks the calls
    int left;                 // number of calls that still succeed; below 0: all
    int error;                // the error of the next call
    bool for_good;            // all later calls fail, too: the power is off
    char log[64];             // one letter for each call
    unsigned pause;           // microseconds before and after each unlink and connect
} faults = {false, -1, 0, false, "", 0};

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

// Writes half of the data, then nothing, like a disk that becomes full.
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

static int paused(int result)
{
    const int error = errno;

    if (faults.pause > 0)
        (void)usleep(faults.pause);
    errno = error;
    return result;
}

int __wrap_unlink(const char *path)
{
    (void)paused(0);
    return fails('u') ? -1 : paused(__real_unlink(path));
}

long __wrap_syscall(long number, ...)
{
    long argument[6];
    va_list list;

    if (number != SYS_futex)                               // this call requests the thread's number
        return __real_syscall(number);
    va_start(list, number);
    for (int i = 0; i < 6; i++)
        argument[i] = va_arg(list, long);
    va_end(list);
    if ((argument[1] & FUTEX_CMD_MASK) != FUTEX_UNLOCK_PI && fails('l'))
        return -1;
    return __real_syscall(number, argument[0], argument[1], argument[2], argument[3], argument[4], argument[5]);
}

int __wrap_timer_settime(timer_t timer, int flags, const struct itimerspec *to, struct itimerspec *old)
{
    return fails('t') ? -1 : __real_timer_settime(timer, flags, to, old);
}

int __wrap_ppoll(struct pollfd *fds, nfds_t n, const struct timespec *timeout, const sigset_t *mask)
{
    return fails('p') ? -1 : __real_ppoll(fds, n, timeout, mask);
}

int __wrap_accept4(int fd, struct sockaddr *a, socklen_t *n, int flags) { return fails('a') ? -1 : __real_accept4(fd, a, n, flags); }
ssize_t __wrap_recvmsg(int fd, struct msghdr *m, int flags) { return fails('m') ? -1 : __real_recvmsg(fd, m, flags); }

int __wrap_connect(int fd, const struct sockaddr *a, socklen_t n)
{
    (void)paused(0);
    return fails('c') ? -1 : paused(__real_connect(fd, a, n));
}

void pause_calls(unsigned microseconds) { faults.pause = microseconds; }

void fault(int left, int error, bool for_good)
{
    faults.watching = true;
    faults.left = left;
    faults.error = error;
    faults.for_good = for_good;
    faults.log[0] = '\0';
}

void no_fault(void)
{
    faults.watching = false;
}

const char *calls(void)
{
    return faults.log;
}
