// SPDX-License-Identifier: Apache-2.0
// Analog channels: numeric controls and indicators of the FPGA's VI (fpga.h).
#include "runtime-c/pal/aio.h"
#include "runtime-c/psl/linux/linux.h"
#include "runtime-c/psl/sbrio/session.h"

#define MILLION 1000000.0

typedef struct ChannelEntry {
    const SbrioPin *row;
    bool written;             // the output has been written since it was opened
} ChannelEntry;

static bool used[PAL_AIOS];
static ChannelEntry entries[PAL_AIOS];

// ---- opening ----

static bool is_open(const SbrioPin *row)
{
    for (uint8_t i = 0; i < PAL_AIOS; i++)
        if (used[i] && entries[i].row == row)
            return true;
    return false;
}

// Opens a channel in a free entry of the table; *id: its handle number. Called with the tables locked.
static SmResult open_entry(const SbrioPin *row, PalAioMode mode, uint8_t *id)
{
    SmResult r;

    if (is_open(row))
        return SM_E_BUSY;
    if (row->output != (mode == PAL_AIO_OUTPUT))
        return SM_E_UNSUPPORTED;
    *id = psl_table_allocate(used, PAL_AIOS);
    if (*id == 0)
        return SM_E_FULL;
    entries[*id - 1].row = row;
    entries[*id - 1].written = false;
    r = sbrio_open();
    used[*id - 1] = r == SM_OK;
    return r;
}

SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode)
{
    const SbrioPin *row;
    uint8_t id = 0;
    SmResult r;

    if (!channel || (unsigned)mode > PAL_AIO_OUTPUT)
        return SM_E_ARGUMENT;
    r = sbrio_find(false, number, &row);
    if (r != SM_OK)
        return r;
    psl_lock_tables();
    r = open_entry(row, mode, &id);
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

static int32_t millionths_of(const SbrioPin *row, double value) { return round_saturated((value * row->scale + row->zero) * MILLION); }

SmResult pal_aio_info(PalAio channel, PalAioInfo *info)
{
    const SbrioPin *row;
    const SbrioRange *range;
    double step;

    if (!info)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    row = entries[channel.id - 1].row;
    range = &sbrio_ranges[row->type];
    step = (row->scale < 0 ? -row->scale : row->scale) * MILLION;
    info->lowest = millionths_of(row, row->scale < 0 ? range->highest : range->lowest);
    info->highest = millionths_of(row, row->scale < 0 ? range->lowest : range->highest);
    info->step = !range->whole ? 0 : step >= UINT32_MAX ? UINT32_MAX : (uint32_t)step;
    return SM_OK;
}

// An indicator of a floating-point type that is NaN has no measurement.
SmResult pal_aio_read(PalAio channel, int32_t *millionths)
{
    double value = 0;
    SmResult r;

    if (!millionths)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    if (entries[channel.id - 1].row->output)
        return SM_E_ARGUMENT;
    r = sbrio_read(entries[channel.id - 1].row, &value);
    if (r == SM_OK && value != value)
        r = SM_E_DEVICE;
    if (r == SM_OK)
        *millionths = millionths_of(entries[channel.id - 1].row, value);
    return r;
}

// The first write does not start the VI, so that the output begins with this value.
SmResult pal_aio_write(PalAio channel, int32_t millionths)
{
    ChannelEntry *e;
    SmResult r;

    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    e = &entries[channel.id - 1];
    if (!e->row->output)
        return SM_E_ARGUMENT;
    r = e->written ? sbrio_start() : SM_OK;
    if (r == SM_OK)
        r = sbrio_write(e->row, (millionths / MILLION - e->row->zero) / e->row->scale);
    e->written = e->written || r == SM_OK;
    return r;
}

SmResult pal_aio_close(PalAio channel)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_AIOS, channel.id)) {
        used[channel.id - 1] = false;
        sbrio_close();
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
