// SPDX-License-Identifier: Apache-2.0
// Digital pins: Boolean controls and indicators of the FPGA's VI (fpga.h).
#include "runtime-c/pal/dio.h"
#include "runtime-c/psl/linux/linux.h"
#include "runtime-c/psl/sbrio/session.h"

static bool used[PAL_DIOS];
static const SbrioPin *entries[PAL_DIOS];

static bool is_open(const SbrioPin *row)
{
    for (uint8_t i = 0; i < PAL_DIOS; i++)
        if (used[i] && entries[i] == row)
            return true;
    return false;
}

// Whether the pin supports the mode.  A resistor must be the one that the board has.
static bool has_mode(const SbrioPin *row, PalDioMode mode)
{
    if (row->output || mode == PAL_DIO_OUTPUT)
        return row->output && mode == PAL_DIO_OUTPUT;
    return mode == PAL_DIO_INPUT || row->pull == (mode == PAL_DIO_PULL_UP ? SBRIO_UP : SBRIO_DOWN);
}

// Opens the session; an output receives its level before the VI starts.
static SmResult open_pin(const SbrioPin *row, bool level)
{
    SmResult r = sbrio_open();

    if (r != SM_OK || !row->output)
        return r;
    r = sbrio_write(row, level);
    if (r != SM_OK)
        sbrio_close();
    return r;
}

// Opens a pin in a free entry of the table; *id: its handle number. Called with the tables locked.
static SmResult open_entry(const SbrioPin *row, PalDioMode mode, bool level, uint8_t *id)
{
    SmResult r;

    if (is_open(row))
        return SM_E_BUSY;
    if (!has_mode(row, mode))
        return SM_E_UNSUPPORTED;
    *id = psl_table_allocate(used, PAL_DIOS);
    if (*id == 0)
        return SM_E_FULL;
    entries[*id - 1] = row;
    r = open_pin(row, level);
    used[*id - 1] = r == SM_OK;
    return r;
}

SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level)
{
    const SbrioPin *row;
    uint8_t id = 0;
    SmResult r;

    if (!pin || (unsigned)mode > PAL_DIO_OUTPUT)
        return SM_E_ARGUMENT;
    r = sbrio_find(true, number, &row);
    if (r != SM_OK)
        return r;
    psl_lock_tables();
    r = open_entry(row, mode, level, &id);
    psl_unlock_tables();
    if (r == SM_OK)
        pin->id = id;
    return r;
}

SmResult pal_dio_read(PalDio pin, bool *level)
{
    double value = 0;
    SmResult r;

    if (!level)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    r = sbrio_read(entries[pin.id - 1], &value);
    if (r == SM_OK)
        *level = value != 0;
    return r;
}

SmResult pal_dio_write(PalDio pin, bool level)
{
    SmResult r;

    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    if (!entries[pin.id - 1]->output)
        return SM_E_ARGUMENT;
    r = sbrio_start();
    return r == SM_OK ? sbrio_write(entries[pin.id - 1], level) : r;
}

SmResult pal_dio_close(PalDio pin)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_DIOS, pin.id)) {
        used[pin.id - 1] = false;
        sbrio_close();
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
