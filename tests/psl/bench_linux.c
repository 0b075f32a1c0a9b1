// SPDX-License-Identifier: Apache-2.0
// The bench of the Linux platform: this computer, with a pseudo-terminal as a serial line.  What leaves files works in a folder
// of its own.  Digital pins are tried where there is a /dev/gpiochip0 whose lines may be used: PSL_PINS=1 says so.
#define _GNU_SOURCE
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

Bench bench = {
    .name = "linux", .clock = HAS, .console = HAS, .threads = HAS, .locks = HAS, .sockets = HAS,
    .nvm = HAS, .nvm_name = "nvm", .nvm_size = 1000, .nvm_missing = "no-such-folder/nvm",
    .serial = HAS, .serial_name = line, .far_send = far_send, .far_receive = far_receive, .far_unplug = far_unplug,
    .dio = HAS_NOTHING_THERE, .pins = {2, 3}, .pin_missing = 999,
    .own = own_linux,
};

void bench_begin(void)
{
    const char *base = getenv("TMPDIR");

    snprintf(folder, sizeof folder, "%s/smc-psl.XXXXXX", base ? base : P_tmpdir);
    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
    far_end = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    CHECK(far_end >= 0 && grantpt(far_end) == 0 && unlockpt(far_end) == 0 && ptsname_r(far_end, line, sizeof line) == 0);
    if (getenv("PSL_PINS"))
        bench.dio = HAS;
}

Tally bench_end(void)
{
    unlink("nvm");
    CHECK(chdir("/") == 0 && rmdir(folder) == 0);         // fails if a test left a file
    return TALLY();
}
