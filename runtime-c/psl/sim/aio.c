// SPDX-License-Identifier: Apache-2.0
// Simulated analog channels, 0 to 15: ±10 V with a resolution of 5 µV, like a typical instrument.
#include <string.h>

#include "runtime-c/pal/aio.h"
#include "runtime-c/psl/sim/world.h"

#define CHANNELS 16
#define LIMIT    10000000
#define STEP     5

static struct {
    bool open;
    int32_t value;
    uint16_t source;          // 1 + number of the channel to which it is wired; 0: none
} channels[CHANNELS];

static bool used[PAL_AIOS];
static struct {
    uint8_t channel;
    bool output;
} entries[PAL_AIOS];

void sim_aio_reset(void)
{
    memset(channels, 0, sizeof channels);
    memset(used, 0, sizeof used);
}

// Limits x to what the simulated channels can measure, and truncates it to their resolution.
static int32_t limit_and_truncate(int32_t x)
{
    return (x < -LIMIT ? -LIMIT : x > LIMIT ? LIMIT : x) / STEP * STEP;
}

// Sets the value that an analog channel measures, in millionths.
void sim_set_analog(uint16_t channel, int32_t millionths)
{
    channels[channel].value = limit_and_truncate(millionths);
}

// Returns the value of an analog output, in millionths.
int32_t sim_analog(uint16_t channel)
{
    return channels[channel].source ? channels[channels[channel].source - 1].value : channels[channel].value;
}

void sim_wire_analog(uint16_t from, uint16_t to)
{
    channels[to].source = (uint16_t)(from + 1);
}

SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode)
{
    SmResult r;
    uint8_t id;

    if (!channel || (unsigned)mode > PAL_AIO_OUTPUT)
        return SM_E_ARGUMENT;
    if (number >= CHANNELS)
        return SM_E_MISSING;
    r = channels[number].open ? SM_E_BUSY : sim_begin_call(SIM_aio_open);
    if (r != SM_OK)
        return r;
    id = psl_table_allocate(used, PAL_AIOS);
    if (id == 0)
        return SM_E_FULL;
    channels[number].open = true;
    entries[id - 1].channel = (uint8_t)number;
    entries[id - 1].output = mode == PAL_AIO_OUTPUT;
    channel->id = id;
    return SM_OK;
}

SmResult pal_aio_info(PalAio channel, PalAioInfo *info)
{
    if (!info)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    info->lowest = -LIMIT;
    info->highest = LIMIT;
    info->step = STEP;
    return SM_OK;
}

SmResult pal_aio_read(PalAio channel, int32_t *millionths)
{
    SmResult r;

    if (!millionths)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    if (entries[channel.id - 1].output)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_aio_read);
    if (r == SM_OK)
        *millionths = sim_analog(entries[channel.id - 1].channel);
    return r;
}

SmResult pal_aio_write(PalAio channel, int32_t millionths)
{
    SmResult r;

    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    if (!entries[channel.id - 1].output)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_aio_write);
    if (r == SM_OK)
        sim_set_analog(entries[channel.id - 1].channel, millionths);
    return r;
}

SmResult pal_aio_close(PalAio channel)
{
    if (!psl_table_is_used(used, PAL_AIOS, channel.id))
        return SM_E_HANDLE;
    used[channel.id - 1] = false;
    channels[entries[channel.id - 1].channel].open = false;
    return SM_OK;
}
