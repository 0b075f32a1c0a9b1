// SPDX-License-Identifier: Apache-2.0
// Analog channels: the IIO subsystem through sysfs, which has one file for each value.  Channel 1000 × device + channel is voltage
// `channel` of iio:device`device`, or else its current `channel`.  (raw + offset) × scale is in millivolts or milliamperes.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "runtime-c/pal/aio.h"
#include "runtime-c/psl/linux/linux.h"

#define CHANNELS_OF_A_DEVICE 1000u

typedef struct AioEntry {
    int fd;                   // descriptor of the file of the raw value
    bool output;
    uint16_t number;
    double offset, scale;     // scale: millionths per step
} AioEntry;

static bool used[PAL_AIOS];
static AioEntry entries[PAL_AIOS];

// ---- sysfs values ----

// Parses a decimal number at the start of `text`, independent of the locale; 0 if the text begins with no number.
static double parse_number(const char *text)
{
    double x = 0, unit = 1;
    bool negative = *text == '-', fraction = false;

    for (text += negative; (*text >= '0' && *text <= '9') || (*text == '.' && !fraction); text++) {
        if (*text == '.') {
            fraction = true;
            continue;
        }
        x = x * 10 + (*text - '0');
        unit = fraction ? unit * 10 : unit;
    }
    return (negative ? -x : x) / unit;
}

// Reads the number in a sysfs file.
static SmResult read_number(int fd, double *x)
{
    char text[64];
    ssize_t n = pread(fd, text, sizeof text - 1, 0);

    if (n <= 0)
        return n < 0 && errno == EAGAIN ? SM_E_DEVICE : n < 0 ? psl_result_of_errno(errno) : SM_E_DEVICE;
    text[n] = '\0';
    if (text[0] != '-' && (text[0] < '0' || text[0] > '9'))
        return SM_E_DEVICE;
    *x = parse_number(text);
    return SM_OK;
}

static SmResult write_number(int fd, long long x)
{
    char text[32];
    int n = snprintf(text, sizeof text, "%lld\n", x);

    return pwrite(fd, text, (size_t)n, 0) == n ? SM_OK : errno == EINVAL ? SM_E_DEVICE : psl_result_of_errno(errno);
}

// Opens the file `name` of the channel's device.  Returns -1 and sets errno on failure.
static int open_file(uint16_t number, const char *name, int flags)
{
    char path[PAL_NAME + 64];

    snprintf(path, sizeof path, "%s/iio:device%u/%s", PSL_LINUX_IIO, number / CHANNELS_OF_A_DEVICE, name);
    return open(path, flags | O_CLOEXEC);
}

// Reads a setting of the channel ("in_voltage3_scale"), else of its device ("in_voltage_scale"), else returns `otherwise`.
static double read_setting(uint16_t number, const char *what, const char *kind, double otherwise)
{
    char name[64];
    double x = otherwise;
    int fd;

    snprintf(name, sizeof name, "%s%u_%s", what, number % CHANNELS_OF_A_DEVICE, kind);
    fd = open_file(number, name, O_RDONLY);
    if (fd < 0) {
        snprintf(name, sizeof name, "%s_%s", what, kind);
        fd = open_file(number, name, O_RDONLY);
    }
    if (fd >= 0) {
        if (read_number(fd, &x) != SM_OK)
            x = otherwise;
        close(fd);
    }
    return x;
}

// ---- opening ----

// Opens the first of the files `what[i]` NUMBER_raw that exists, and reads its scale and offset.
static SmResult open_channel(AioEntry *e, const char *const *what)
{
    for (; *what; what++) {
        char name[64];

        snprintf(name, sizeof name, "%s%u_raw", *what, e->number % CHANNELS_OF_A_DEVICE);
        e->fd = open_file(e->number, name, e->output ? O_WRONLY : O_RDONLY);
        if (e->fd >= 0) {
            e->scale = read_setting(e->number, *what, "scale", 1) * 1000;
            e->offset = read_setting(e->number, *what, "offset", 0);
            return e->scale != 0 ? SM_OK : SM_E_DEVICE;
        }
        if (errno != ENOENT)
            return psl_result_of_errno(errno);
    }
    return SM_E_MISSING;
}

// Opens the files of a channel for a new entry of the table. SM_E_BUSY: another entry uses the channel.
static SmResult open_entry(AioEntry *e, uint16_t number, PalAioMode mode)
{
    static const char *const inputs[] = {"in_voltage", "in_current", NULL}, *const outputs[] = {"out_voltage", "out_current", NULL};
    SmResult r;

    for (uint8_t i = 0; i < PAL_AIOS; i++)
        if (used[i] && &entries[i] != e && entries[i].number == number && entries[i].output == (mode == PAL_AIO_OUTPUT))
            return SM_E_BUSY;
    e->fd = -1;
    e->number = number;
    e->output = mode == PAL_AIO_OUTPUT;
    r = open_channel(e, e->output ? outputs : inputs);
    if (r != SM_OK && e->fd >= 0)
        close(e->fd);
    return r;
}

SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode)
{
    SmResult r = SM_E_FULL;
    uint8_t id;

    if (!channel || (unsigned)mode > PAL_AIO_OUTPUT)
        return SM_E_ARGUMENT;
    psl_lock_tables();
    id = psl_table_allocate(used, PAL_AIOS);
    if (id != 0) {
        r = open_entry(&entries[id - 1], number, mode);
        used[id - 1] = r == SM_OK;
    }
    psl_unlock_tables();
    if (r == SM_OK)
        channel->id = id;
    return r;
}

// ---- using ----

// Rounds to the nearest integer, saturated.
static int32_t round_saturated(double x)
{
    return x >= INT32_MAX ? INT32_MAX : x <= INT32_MIN ? INT32_MIN : (int32_t)(x < 0 ? x - 0.5 : x + 0.5);
}

SmResult pal_aio_info(PalAio channel, PalAioInfo *info)
{
    double step;

    if (!info)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    step = entries[channel.id - 1].scale < 0 ? -entries[channel.id - 1].scale : entries[channel.id - 1].scale;
    info->lowest = INT32_MIN;                             // sysfs reports the range of few channels only
    info->highest = INT32_MAX;
    info->step = step >= UINT32_MAX ? UINT32_MAX : (uint32_t)step;
    return SM_OK;
}

SmResult pal_aio_read(PalAio channel, int32_t *millionths)
{
    const AioEntry *e;
    double raw;
    SmResult r;

    if (!millionths)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    e = &entries[channel.id - 1];
    if (e->output)
        return SM_E_ARGUMENT;
    r = read_number(e->fd, &raw);
    if (r == SM_OK)
        *millionths = round_saturated((raw + e->offset) * e->scale);
    return r;
}

SmResult pal_aio_write(PalAio channel, int32_t millionths)
{
    const AioEntry *e;

    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    e = &entries[channel.id - 1];
    if (!e->output)
        return SM_E_ARGUMENT;
    return write_number(e->fd, round_saturated(millionths / e->scale - e->offset));
}

SmResult pal_aio_close(PalAio channel)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_AIOS, channel.id)) {
        close(entries[channel.id - 1].fd);
        used[channel.id - 1] = false;
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
