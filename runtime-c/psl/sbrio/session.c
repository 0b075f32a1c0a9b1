// SPDX-License-Identifier: Apache-2.0
// The session with the FPGA (session.h).
#include <float.h>
#include <stdlib.h>

#include "NiFpga.h"
#include "runtime-c/psl/linux/linux.h"
#include "runtime-c/psl/sbrio/session.h"

// Closed; open, but the VI was not started; the VI runs; lost.
typedef enum SessionState { CLOSED, STOPPED, RUNNING, LOST } SessionState;

static NiFpga_Session session;
static unsigned pins;         // how many pins and channels are open
static uint32_t state;        // SessionState; read by every access, without the mutex
static int32_t last_error;

const SbrioRange sbrio_ranges[SBRIO_TYPES] = {
#define SBRIO_TYPE(name, c, lowest, highest, whole) {lowest, highest, whole},
#include "runtime-c/psl/sbrio/types.def"
#undef SBRIO_TYPE
};

static SessionState get_state(void) { return (SessionState)__atomic_load_n(&state, __ATOMIC_ACQUIRE); }
static void set_state(SessionState to) { __atomic_store_n(&state, (uint32_t)to, __ATOMIC_RELEASE); }
int32_t sbrio_last_error(void) { return __atomic_load_n(&last_error, __ATOMIC_RELAXED); }

// ---- statuses ----

enum {
#define SBRIO_STATUS(name, number, result) STATUS_##name = number,
#include "runtime-c/psl/sbrio/status.def"
#undef SBRIO_STATUS
};

static SmResult result_of_error(NiFpga_Status status)
{
    switch (status) {
#define SBRIO_STATUS(name, number, result) case STATUS_##name: return result;
#include "runtime-c/psl/sbrio/status.def"
#undef SBRIO_STATUS
    default: return SM_E_DEVICE;
    }
}

// Converts the status of a call.  A positive one is a warning: the call succeeded.
static SmResult result_of(NiFpga_Status status)
{
    SmResult r;

    if (status >= 0)
        return SM_OK;
    __atomic_store_n(&last_error, status, __ATOMIC_RELAXED);
    r = result_of_error(status);
    if (r == SM_E_CLOSED)
        set_state(LOST);
    return r;
}

// ---- the table ----

// (x - x is NaN for infinities and NaN.)
static bool is_finite(double x) { return x - x == 0; }

static bool is_valid(const SbrioPin *row)
{
    return row->type < SBRIO_TYPES && is_finite(row->scale) && is_finite(row->zero) && row->scale != 0;
}

SmResult sbrio_find(bool digital, uint16_t number, const SbrioPin **row)
{
    const SbrioPin *found = NULL;

    for (uint16_t i = 0; i < sbrio_fpga.pins; i++) {
        const SbrioPin *p = &sbrio_fpga.pin[i];

        if (p->number != number || (p->type == SBRIO_Bool) != digital)
            continue;
        if (found || !is_valid(p))
            return SM_E_ARGUMENT;
        found = p;
    }
    *row = found;
    return found ? SM_OK : SM_E_MISSING;
}

// ---- opening and closing ----

// Opens the session with the FPGA, without starting its program.
static SmResult open_session(void)
{
    SmResult r = result_of(NiFpga_Initialize());

    if (r == SM_OK) {
        r = result_of(NiFpga_Open(sbrio_fpga.bitfile, *sbrio_fpga.signature, sbrio_fpga.resource, NiFpga_OpenAttribute_NoRun, &session));
        if (r != SM_OK)
            (void)NiFpga_Finalize();
    }
    set_state(r == SM_OK ? STOPPED : CLOSED);
    return r;
}

// Closes the session with the FPGA. Its program (the VI) continues to run, so that outputs keep the safe values that the caller has set.
static void close_session(void)
{
    if (get_state() != LOST)
        (void)NiFpga_Close(session, NiFpga_CloseAttribute_NoResetIfLastSession);
    (void)NiFpga_Finalize();
    set_state(CLOSED);
}

// Closes the session at the end of the program, because an application ends with open pins.  exit() calls what was registered last first, so this is
// registered after NI's library was loaded, and runs before the library's own functions for the end of the program.
static void close_at_exit(void)
{
    psl_lock_tables();
    if (pins > 0)
        close_session();
    pins = 0;
    psl_unlock_tables();
}

SmResult sbrio_open(void)
{
    static bool registered;
    SmResult r = pins == 0 ? open_session() : get_state() == LOST ? SM_E_CLOSED : SM_OK;

    pins += r == SM_OK;
    if (r == SM_OK && !registered)
        registered = atexit(close_at_exit) == 0;
    return r;
}

void sbrio_close(void)
{
    if (pins > 0 && --pins == 0)
        close_session();
}

// ---- the VI ----

// Runs the VI.  It runs already if an earlier program left it running.
static SmResult run_vi(void)
{
    const NiFpga_Status status = NiFpga_Run(session, 0);
    const SmResult r = status == STATUS_FpgaAlreadyRunning ? SM_OK : result_of(status);

    if (r == SM_OK)
        set_state(RUNNING);
    return r;
}

SmResult sbrio_start(void)
{
    SmResult r = SM_OK;

    if (get_state() == RUNNING)
        return SM_OK;
    psl_lock_tables();
    if (get_state() == LOST)
        r = SM_E_CLOSED;
    else if (get_state() == STOPPED)
        r = run_vi();
    psl_unlock_tables();
    return r;
}

// ---- values ----

SmResult sbrio_read(const SbrioPin *row, double *value)
{
    SmResult r = sbrio_start();

    if (r != SM_OK)
        return r;
    switch ((SbrioType)row->type) {
#define SBRIO_TYPE(name, c, lowest, highest, whole) \
    case SBRIO_##name: { \
        c x = 0; \
        r = result_of(NiFpga_Read##name(session, row->address, &x)); \
        if (r == SM_OK) \
            *value = (double)x; \
        return r; \
    }
#include "runtime-c/psl/sbrio/types.def"
#undef SBRIO_TYPE
    case SBRIO_TYPES: break;
    }
    return SM_E_ARGUMENT;
}

// Returns the nearest value of the type; for whole numbers, halves away from 0.
static double nearest_of_type(const SbrioRange *range, double x)
{
    if (x <= range->lowest)
        return range->lowest;
    if (x >= range->highest)
        return range->highest;
    if (!range->whole || x >= 4503599627370496.0 || x <= -4503599627370496.0)      // from 2^52 on, every double is whole
        return x;
    return (double)(int64_t)(x < 0 ? x - 0.5 : x + 0.5);
}

SmResult sbrio_write(const SbrioPin *row, double value)
{
    const double x = nearest_of_type(&sbrio_ranges[row->type], value);

    if (get_state() == LOST)
        return SM_E_CLOSED;
    switch ((SbrioType)row->type) {
#define SBRIO_TYPE(name, c, lowest, highest, whole) case SBRIO_##name: return result_of(NiFpga_Write##name(session, row->address, (c)x));
#include "runtime-c/psl/sbrio/types.def"
#undef SBRIO_TYPE
    case SBRIO_TYPES: break;
    }
    return SM_E_ARGUMENT;
}
