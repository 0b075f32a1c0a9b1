// SPDX-License-Identifier: Apache-2.0
// The guarantees of serial.h, with the bench at the other end of the line.
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/serial.h"
#include "tests/psl/suite.h"

#define SPEED 115200u
#define SOON  (10 * (uint64_t)PAL_SECOND)     // a limit for data that arrives at once, on a computer under load

static void without(SmResult expected)
{
    PalSerial line = {0};
    size_t n = 7;
    uint8_t x = 0;

    CHECK(pal_serial_open(&line, "line", SPEED) == expected && line.id == 0);
    if (expected != SM_E_UNSUPPORTED)
        return;
    CHECK(pal_serial_open(NULL, NULL, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_serial_send(line, &x, 1, &n, 0) == SM_E_UNSUPPORTED && n == 0);
    CHECK(pal_serial_send(line, &x, 1, NULL, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_serial_receive(line, &x, 1, &n, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_serial_close(line) == SM_E_UNSUPPORTED);
}

static void bad_arguments(void)
{
    const uint8_t bad[] = {0, PAL_SERIALS, PAL_SERIALS + 1, 255};
    char name[PAL_NAME + 1];
    PalSerial line = {0};
    size_t n;
    uint8_t x = 0;

    memset(name, 'x', PAL_NAME);
    name[PAL_NAME] = '\0';
    CHECK(pal_serial_open(NULL, bench.serial_name, SPEED) == SM_E_ARGUMENT);
    CHECK(pal_serial_open(&line, NULL, SPEED) == SM_E_ARGUMENT);
    CHECK(pal_serial_open(&line, name, SPEED) == SM_E_ARGUMENT);
    CHECK(pal_serial_open(&line, bench.serial_name, 0) == SM_E_ARGUMENT);
    CHECK(pal_serial_open(&line, bench.serial_name, 12345) == SM_E_ARGUMENT);
    CHECK(pal_serial_open(&line, "no-such-line", SPEED) == SM_E_MISSING);
    CHECK(line.id == 0);
    for (size_t i = 0; i < COUNT(bad); i++) {
        line.id = bad[i];
        CHECK(pal_serial_send(line, &x, 1, &n, 0) == SM_E_HANDLE && n == 0);
        CHECK(pal_serial_receive(line, &x, 1, &n, 0) == SM_E_HANDLE);
        CHECK(pal_serial_close(line) == SM_E_HANDLE);
    }
}

static PalSerial opened(void)
{
    PalSerial line = {0}, again = {0};
    size_t n = 7;
    uint8_t x = 0;

    CHECK(pal_serial_open(&line, bench.serial_name, SPEED) == SM_OK && line.id != 0);
    CHECK(pal_serial_open(&again, bench.serial_name, SPEED) == SM_E_BUSY && again.id == 0);
    CHECK(pal_serial_send(line, NULL, 1, &n, 0) == SM_E_ARGUMENT && n == 0);
    CHECK(pal_serial_send(line, &x, 1, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_serial_send(line, &x, 1, &n, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_serial_send(line, &x, 0, &n, 0) == SM_OK && n == 0);
    CHECK(pal_serial_receive(line, NULL, 1, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_serial_receive(line, &x, 1, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_serial_receive(line, &x, 0, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_serial_receive(line, &x, 1, &n, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    return line;
}

// Whether exactly n bytes are received, in any number of pieces.
static bool receives(PalSerial line, uint8_t *bytes, size_t n)
{
    size_t all = 0, got = 0;

    while (all < n && pal_serial_receive(line, bytes + all, n - all, &got, SOON) == SM_OK)
        all += got;
    return all == n;
}

static bool far_gains(uint8_t *bytes, size_t n)
{
    uint64_t end = pal_clock_now() + SOON;
    size_t all = 0;

    while (all < n && pal_clock_now() < end) {
        all += bench.far_receive(bytes + all, n - all);
        if (all < n)
            pal_clock_sleep_until(pal_clock_now() + MS);
    }
    return all == n;
}

// Every byte arrives unchanged in both directions.  A terminal would change some bytes and act on others.
static void test_all_bytes(PalSerial line)
{
    uint8_t out[256], in[256] = {0};
    size_t n = 0;

    for (size_t i = 0; i < sizeof out; i++)
        out[i] = (uint8_t)i;
    for (size_t i = 0; i < sizeof out; i += 64) {          // every platform buffers at least 64 bytes
        bench.far_send(out + i, 64);
        CHECK(receives(line, in + i, 64));
    }
    CHECK(memcmp(in, out, sizeof in) == 0);
    CHECK(pal_serial_send(line, out, sizeof out, &n, SOON) == SM_OK && n == sizeof out);
    memset(in, 0, sizeof in);
    CHECK(far_gains(in, sizeof in) && memcmp(in, out, sizeof in) == 0);
    CHECK(bench.far_receive(in, 1) == 0);                 // there is no echo
}

static void test_timeouts(PalSerial line)
{
    uint8_t x[10];
    uint64_t before = pal_clock_now();
    size_t n = 7;

    CHECK(pal_serial_receive(line, x, sizeof x, &n, 0) == SM_E_TIMEOUT && n == 7);
    CHECK(pal_serial_receive(line, x, sizeof x, &n, 5 * MS) == SM_E_TIMEOUT && n == 7);
    CHECK(pal_clock_now() - before >= 5 * MS);
    bench.far_send("ab", 2);                              // receiving returns fewer bytes than there is room for, without waiting
    CHECK(receives(line, x, 2) && memcmp(x, "ab", 2) == 0);
}

// The bytes are not read: send returns at its timeout, with the number of bytes that it sent.
static void test_no_reader(PalSerial line)
{
    uint8_t bytes[256] = {0};
    uint64_t before = pal_clock_now();
    size_t n = 0, went = 0, came = 0;
    SmResult r = SM_OK;

    for (int i = 0; i < 10000 && r == SM_OK; i++) {
        r = pal_serial_send(line, bytes, sizeof bytes, &n, 5 * MS);
        went += n;
    }
    CHECK(r == SM_E_TIMEOUT && n < sizeof bytes);
    CHECK(pal_clock_now() - before >= 5 * MS);
    while ((n = bench.far_receive(bytes, sizeof bytes)) > 0)
        came += n;
    CHECK(came == went);
}

static void test_unplugged(PalSerial line)
{
    uint8_t x;
    size_t n;

    bench.far_unplug();
    CHECK(pal_serial_receive(line, &x, 1, &n, PAL_SECOND) == SM_E_CLOSED);
    CHECK(pal_serial_send(line, "x", 1, &n, PAL_SECOND) == SM_E_CLOSED && n == 0);
    CHECK(pal_serial_close(line) == SM_OK);
    CHECK(pal_serial_close(line) == SM_E_HANDLE);
}

Tally contract_serial(void)
{
    PalSerial line;

    if (bench.serial != HAS) {
        without(bench.serial == HAS_NONE ? SM_E_UNSUPPORTED : SM_E_MISSING);
        return TALLY();
    }
    bad_arguments();
    line = opened();
    test_all_bytes(line);
    test_timeouts(line);
    test_no_reader(line);
    CHECK(pal_serial_close(line) == SM_OK);
    bench.far_send("old", 3);
    line = opened();
    test_timeouts(line);                                       // earlier input is dropped
    test_unplugged(line);
    return TALLY();
}
