// SPDX-License-Identifier: Apache-2.0
// The common part of the benches of platforms on Linux: a separate folder, a pseudo-terminal as a serial line, and the log as a file.
#ifndef PSL_BENCH_HOST_H
#define PSL_BENCH_HOST_H

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/psl/suite.h"

static char folder[256], line[64];
static int far_end;

static void far_send(const void *bytes, size_t n)
{
    CHECK(write(far_end, bytes, n) == (ssize_t)n);
}

static size_t far_receive(void *bytes, size_t room)
{
    ssize_t got = read(far_end, bytes, room);

    return got > 0 ? (size_t)got : 0;
}

static void far_unplug(void)
{
    close(far_end);
}

static size_t log_read(void *bytes, size_t room)
{
    FILE *f = fopen("flight.log", "rb");
    size_t n = f ? fread(bytes, 1, room, f) : 0;

    if (f)
        fclose(f);
    return n;
}

static void host_begin(void)
{
    const char *base = getenv("TMPDIR");

    snprintf(folder, sizeof folder, "%s/smc-psl.XXXXXX", base ? base : P_tmpdir);
    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
    far_end = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    CHECK(far_end >= 0 && grantpt(far_end) == 0 && unlockpt(far_end) == 0 && ptsname_r(far_end, line, sizeof line) == 0);
}

static void host_end(void)
{
    unlink("nvm");
    unlink("flight.log");
    CHECK(chdir("/") == 0 && rmdir(folder) == 0);         // fails if a test left a file
}

#endif
