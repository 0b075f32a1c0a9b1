// SPDX-License-Identifier: Apache-2.0
// The guarantees of aio.h.
#include "runtime-c/pal/aio.h"
#include "tests/psl/suite.h"

static void without(SmResult expected)
{
    PalAio channel = {0};
    PalAioInfo info;
    int32_t x = 7;

    CHECK(pal_aio_open(&channel, bench.channel_in, PAL_AIO_INPUT) == expected && channel.id == 0);
    if (expected != SM_E_UNSUPPORTED)
        return;
    CHECK(pal_aio_open(NULL, 0, PAL_AIO_INPUT) == SM_E_UNSUPPORTED);
    CHECK(pal_aio_info(channel, &info) == SM_E_UNSUPPORTED);
    CHECK(pal_aio_read(channel, &x) == SM_E_UNSUPPORTED && x == 7);
    CHECK(pal_aio_write(channel, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_aio_close(channel) == SM_E_UNSUPPORTED);
}

static void bad_arguments(void)
{
    const uint8_t bad[] = {0, PAL_AIOS, PAL_AIOS + 1, 255};
    PalAio channel = {0};
    PalAioInfo info;
    int32_t x = 7;

    CHECK(pal_aio_open(NULL, bench.channel_in, PAL_AIO_INPUT) == SM_E_ARGUMENT);
    CHECK(pal_aio_open(&channel, bench.channel_in, (PalAioMode)99) == SM_E_ARGUMENT);
    for (int i = 0; i < PAL_AIOS + 1; i++)                // a failed call uses up no entry
        CHECK(pal_aio_open(&channel, bench.channel_missing, PAL_AIO_INPUT) == SM_E_MISSING);
    CHECK(channel.id == 0);
    for (size_t i = 0; i < COUNT(bad); i++) {
        channel.id = bad[i];
        CHECK(pal_aio_info(channel, &info) == SM_E_HANDLE);
        CHECK(pal_aio_read(channel, &x) == SM_E_HANDLE && x == 7);
        CHECK(pal_aio_write(channel, 0) == SM_E_HANDLE);
        CHECK(pal_aio_close(channel) == SM_E_HANDLE);
    }
}

static PalAio opened(uint16_t number, PalAioMode mode)
{
    PalAio channel = {0}, again = {0};

    CHECK(pal_aio_open(&channel, number, mode) == SM_OK && channel.id != 0);
    CHECK(pal_aio_open(&again, number, mode) == SM_E_BUSY && again.id == 0);
    return channel;
}

// Whether the read value equals the written one, except for one step of each channel.
static bool is_near(int32_t a, int32_t b, const PalAioInfo *in, const PalAioInfo *out)
{
    int64_t off = (int64_t)a - b, step = (int64_t)in->step + out->step + 1;

    return off >= -step && off <= step;
}

static void values(PalAio in, PalAio out)
{
    const int32_t tried[] = {0, 1000000, 2500000, 12345};
    PalAioInfo of_in = {0, 0, 0}, of_out = {0, 0, 0};
    int32_t x = 0;

    CHECK(pal_aio_info(in, &of_in) == SM_OK && of_in.lowest < of_in.highest);
    CHECK(pal_aio_info(out, &of_out) == SM_OK && of_out.lowest < of_out.highest);
    for (size_t i = 0; i < COUNT(tried); i++) {
        CHECK(pal_aio_write(out, tried[i]) == SM_OK);
        CHECK(pal_aio_read(in, &x) == SM_OK);
        CHECK(is_near(x, tried[i], &of_in, &of_out));
    }
    if (of_out.highest < INT32_MAX) {                     // beyond the range of the channel: the nearest value
        CHECK(pal_aio_write(out, INT32_MAX) == SM_OK);
        CHECK(pal_aio_read(in, &x) == SM_OK && is_near(x, of_out.highest, &of_in, &of_out));
    }
}

static void bad_use(PalAio in, PalAio out)
{
    int32_t x = 0;

    CHECK(pal_aio_info(in, NULL) == SM_E_ARGUMENT);
    CHECK(pal_aio_read(in, NULL) == SM_E_ARGUMENT);
    CHECK(pal_aio_read(out, &x) == SM_E_ARGUMENT);
    CHECK(pal_aio_write(in, 0) == SM_E_ARGUMENT);
}

Tally contract_aio(void)
{
    PalAio in, out;

    if (bench.aio != HAS) {
        without(bench.aio == HAS_NONE ? SM_E_UNSUPPORTED : SM_E_MISSING);
        return TALLY();
    }
    bad_arguments();
    in = opened(bench.channel_in, PAL_AIO_INPUT);
    out = opened(bench.channel_out, PAL_AIO_OUTPUT);
    bad_use(in, out);
    if (bench.analog_wired)
        values(in, out);
    CHECK(pal_aio_close(in) == SM_OK && pal_aio_close(in) == SM_E_HANDLE);
    CHECK(pal_aio_close(out) == SM_OK);
    CHECK(pal_aio_close(opened(bench.channel_in, PAL_AIO_INPUT)) == SM_OK);
    return TALLY();
}
