// SPDX-License-Identifier: Apache-2.0
// Functions shared by the files of this platform.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "runtime-c/psl/linux/linux.h"

static pthread_mutex_t guard = PTHREAD_MUTEX_INITIALIZER;

void psl_lock_tables(void)
{
    pthread_mutex_lock(&guard);
}

void psl_unlock_tables(void)
{
    pthread_mutex_unlock(&guard);
}

// Reserves an entry of a table (table.h), with the mutex locked only during this call.  Returns its number, from 1; 0: the table is full.
uint8_t psl_allocate(bool *used, uint8_t size)
{
    uint8_t id;

    psl_lock_tables();
    id = psl_table_allocate(used, size);
    psl_unlock_tables();
    return id;
}

void psl_free(bool *used, uint8_t id)
{
    psl_lock_tables();
    used[id - 1] = false;
    psl_unlock_tables();
}

// Converts an errno to a result; SM_E_DEVICE for an error without a PAL code.
SmResult psl_result_of_errno(int error)
{
    switch (error) {
    case 0: return SM_OK;
    case EAGAIN: case ETIMEDOUT: return SM_E_TIMEOUT;
    case EBUSY: case EADDRINUSE: return SM_E_BUSY;
    case EPIPE: case ECONNRESET: case ECONNABORTED: case ENOTCONN: return SM_E_CLOSED;
    case ENOENT: case ENODEV: case ENXIO: case ENOTDIR: case EADDRNOTAVAIL: return SM_E_MISSING;
    case EPERM: case EACCES: case EROFS: return SM_E_DENIED;
    case ENOSPC: case EDQUOT: case EFBIG: return SM_E_SPACE;
    case ENOMEM: return SM_E_MEMORY;
    case EMFILE: case ENFILE: return SM_E_FULL;
    case ECONNREFUSED: case EHOSTUNREACH: case ENETUNREACH: case ENETDOWN: return SM_E_UNREACHABLE;
    case ENOSYS: case EOPNOTSUPP: case ENOTTY: case ELOOP: return SM_E_UNSUPPORTED;
    default: return SM_E_DEVICE;
    }
}

// Converts nanoseconds to a timespec.
struct timespec psl_timespec(uint64_t ns)
{
    struct timespec t;

    t.tv_sec = (time_t)(ns / PAL_SECOND);
    t.tv_nsec = (long)(ns % PAL_SECOND);
    return t;
}

// Waits until one of `events` (of poll) occurs or the clock reaches `deadline`.  Returns SM_OK, SM_E_TIMEOUT or an error.
SmResult psl_wait_for_events(int fd, short events, uint64_t deadline)
{
    struct pollfd p = {fd, events, 0};

    for (;;) {
        uint64_t now = pal_clock_now();
        struct timespec left = psl_timespec(now < deadline ? deadline - now : 0);
        int ready = ppoll(&p, 1, &left, NULL);

        if (ready > 0)
            return SM_OK;
        if (ready < 0 && errno != EINTR)
            return psl_result_of_errno(errno);
        if (ready == 0 && pal_clock_now() >= deadline)
            return SM_E_TIMEOUT;
    }
}

// Blocks SIGPIPE and SIGXFSZ during the write.  An incomplete write may have raised one of them, which is then pending and is
// discarded. A signal that was already pending before the write belongs to the caller and stays pending.
ssize_t psl_write(int fd, const void *bytes, size_t n)
{
    const int numbers[] = {SIGPIPE, SIGXFSZ};
    const struct timespec at_once = {0, 0};
    sigset_t both, own, mask, pending;         // own: the signals of these two that only this write can raise
    ssize_t written;
    int error;

    sigemptyset(&both);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        sigaddset(&both, numbers[i]);
    pthread_sigmask(SIG_BLOCK, &both, &mask);
    sigpending(&pending);
    own = both;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (sigismember(&pending, numbers[i]))
            sigdelset(&own, numbers[i]);
    written = write(fd, bytes, n);
    error = errno;
    if (written != (ssize_t)n)
        while (sigtimedwait(&own, NULL, &at_once) < 0 && errno == EINTR) {}
    pthread_sigmask(SIG_SETMASK, &mask, NULL);
    errno = error;
    return written;
}

// Stores the folder of `path` in `to`, which has PAL_NAME bytes.
static void folder_of(char *to, const char *path)
{
    char *slash;

    strcpy(to, path);
    slash = strrchr(to, '/');
    if (slash)
        slash[slash == to] = '\0';
    else
        strcpy(to, ".");
}

int psl_open_folder(const char *path)
{
    char folder[PAL_NAME];

    folder_of(folder, path);
    return open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

// Waits until the entries of the folder that contains `path` are on the medium (fsync).  Returns 0 or an errno.
int psl_sync_folder(const char *path)
{
    int fd = psl_open_folder(path), error = 0;

    if (fd < 0)
        return errno;
    if (fsync(fd) != 0)
        error = errno;
    close(fd);
    return error;
}
