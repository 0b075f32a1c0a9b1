// SPDX-License-Identifier: Apache-2.0
// How console, analog channels and watchdog of Linux behave on real devices.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/console.h"
#include "runtime-c/pal/watchdog.h"
#include "tests/psl/own_faults_linux.h"
#include "tests/psl/suite.h"

// ---- the console ----

// Reads n bytes, in as many parts as the terminal returns.
static bool read_all(int fd, char *to, size_t n)
{
    ssize_t got = 1;

    for (; n > 0 && got > 0; n -= (size_t)got, to += got)
        got = read(fd, to, n);
    return n == 0;
}

// With `near` as standard output: written bytes arrive at `far`, and a missing reader does not block the writer.
static void test_console_on(int near, int far)
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
    memset(text, '\n', sizeof text);                      // a terminal writes two bytes for it: room for one byte is not enough
    for (; r == SM_OK && calls < 10000; calls++)
        r = pal_console_write(text, sizeof text);
    CHECK(r == SM_E_BUSY && calls > 1);
    CHECK(dup2(saved, STDOUT_FILENO) == STDOUT_FILENO);
    CHECK(close(saved) == 0 && close(near) == 0 && close(far) == 0);
}

static void test_console(void)
{
    int ends[2], terminal = posix_openpt(O_RDWR | O_NOCTTY);
    char name[64];

    CHECK(pipe(ends) == 0);
    test_console_on(ends[1], ends[0]);
    CHECK(grantpt(terminal) == 0 && unlockpt(terminal) == 0 && ptsname_r(terminal, name, sizeof name) == 0);
    test_console_on(open(name, O_RDWR | O_NOCTTY), terminal);
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

// Returns what channel 3007 measures with these files: raw value, offset and scale; NULL: the file is missing.
static int32_t measure_channel(const char *raw, const char *offset, const char *scale)
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

static void test_aio(void)
{
    CHECK(mkdir("iio/iio:device3", 0700) == 0);
    CHECK(measure_channel("12\n", NULL, NULL) == 12000);         // microvolts, which the kernel measures in millivolts
    CHECK(measure_channel("2048\n", NULL, "1.220703125\n") == 2500000);
    CHECK(measure_channel("-4\n", NULL, "0.001\n") == -4);
    CHECK(measure_channel("100\n", "-40.5\n", "2\n") == 119000);
    CHECK(measure_channel("99999999\n", "0\n", "1\n") == INT32_MAX);
    CHECK(measure_channel("-99999999\n", "0\n", "1\n") == INT32_MIN);
    CHECK(measure_channel("", "0\n", "1\n") == -2);
    CHECK(measure_channel("nothing\n", "0\n", "1\n") == -2);
    unlink("iio/iio:device3/in_current7_raw");
    unlink("iio/iio:device3/in_current_offset");
    unlink("iio/iio:device3/in_current7_scale");
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

// Returns the signal that ended a program with such a watchdog; 0: none.
static int watchdog_signal_of(uint64_t period)
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

// The start and each feeding reset the timer.
static void test_feeding(void)
{
    uint64_t actual;

    fault(-1, 0, false);
    CHECK(pal_watchdog_start(PAL_TIMEOUT_MAX, &actual) == SM_OK && actual == PAL_TIMEOUT_MAX);
    CHECK(pal_watchdog_feed() == SM_OK && pal_watchdog_feed() == SM_OK);
    CHECK(strcmp(calls(), "ttt") == 0);
    fault(0, EINVAL, false);
    CHECK(pal_watchdog_feed() == SM_E_DEVICE);
    no_fault();
    CHECK(pal_watchdog_stop() == SM_OK);
}

static void test_watchdog(void)
{
    test_feeding();
    CHECK(watchdog_signal_of(100 * MS) == SIGKILL);
    CHECK(watchdog_signal_of(PAL_TIMEOUT_MAX) == 0);
}

Tally own_devices_linux(void)
{
    test_console();
    test_aio();
    test_watchdog();
    return TALLY();
}
