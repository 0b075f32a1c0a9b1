// SPDX-License-Identifier: Apache-2.0
// The console: standard output.  It may be a terminal, a pipe or a file; where it would make us wait, text is dropped.
#define _GNU_SOURCE
#include <errno.h>
#include <unistd.h>
#include <poll.h>

#include "runtime-c/pal/console.h"
#include "runtime-c/psl/linux/linux.h"

// A pipe that is ready takes so many bytes at once without waiting (PIPE_BUF of POSIX), and does not mix them with others.
#define CHUNK 512u

SmResult pal_console_write(const char *text, size_t n)
{
    if (!text)
        return SM_E_ARGUMENT;
    while (n > 0) {
        ssize_t taken;

        if (psl_wait(STDOUT_FILENO, POLLOUT, 0) != SM_OK)
            return SM_E_BUSY;
        taken = write(STDOUT_FILENO, text, n < CHUNK ? n : CHUNK);
        if (taken < 0 && errno != EINTR)
            return errno == EAGAIN ? SM_E_BUSY : psl_result(errno);
        if (taken > 0) {
            text += taken;
            n -= (size_t)taken;
        }
    }
    return SM_OK;
}
