// SPDX-License-Identifier: Apache-2.0
// The console: standard output, which may be a terminal, a pipe or a file.  Text is dropped if a write would block.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "runtime-c/pal/console.h"
#include "runtime-c/psl/linux/linux.h"

// A pipe that is ready accepts this many bytes at once without blocking and without interleaving (PIPE_BUF of POSIX).
#define CHUNK 512u

// Returns a descriptor for the console.  A terminal that is ready may accept only one byte before it blocks, so it is opened again in
// non-blocking mode.  Standard output itself may be shared with programs that expect blocking mode.
static int open_console(void)
{
    int fd = isatty(STDOUT_FILENO) ? open("/proc/self/fd/1", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC) : -1;

    return fd >= 0 ? fd : STDOUT_FILENO;
}

static SmResult write_all(int fd, const char *text, size_t n)
{
    while (n > 0) {
        ssize_t taken;

        if (psl_wait_for_events(fd, POLLOUT, 0) != SM_OK)
            return SM_E_BUSY;
        taken = psl_write(fd, text, n < CHUNK ? n : CHUNK);
        if (taken < 0 && errno != EINTR)
            return errno == EAGAIN ? SM_E_BUSY : psl_result_of_errno(errno);
        if (taken > 0) {
            text += taken;
            n -= (size_t)taken;
        }
    }
    return SM_OK;
}

SmResult pal_console_write(const char *text, size_t n)
{
    SmResult r;
    int fd;

    if (!text)
        return SM_E_ARGUMENT;
    fd = open_console();
    r = write_all(fd, text, n);
    if (fd != STDOUT_FILENO)
        close(fd);
    return r;
}
