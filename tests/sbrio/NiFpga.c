// SPDX-License-Identifier: Apache-2.0
// The stand-in for NI's library (NiFpga_standin.h).
#define _POSIX_C_SOURCE 200809L
#include "NiFpga_standin.h"

#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LOGGED = 255 };
static const NiFpga_Status invalid_session = -63195, not_initialized = -52010, rpc_session = -63043, already_running = -61003, signature_mismatch = -63106;

static pthread_mutex_t guard = PTHREAD_MUTEX_INITIALIZER;  // protects all variables below; a thread releases it while it is in the library
static struct {
    bool loaded, open, lost, runs, slow;
    NiFpga_Session session;
    int inside, alone;        // number of calls in the library; of those that must not overlap with another
    unsigned calls, until;    // until: number of calls before the injected status
    NiFpga_Status injected;
    uint8_t kind[LOGGED];
    bool expected, broken;
} it;

static void breaks(const char *what)
{
    it.broken = true;
    if (it.expected)
        return;
    fprintf(stderr, "FPGA Interface C API: %s (call %u)\n", what, it.calls);
    fflush(NULL);
    _exit(3);
}

void standin_expect_broken(void) { it.expected = true, it.broken = false; }
bool standin_broken(void)
{
    const bool broken = it.broken;

    it.expected = it.broken = false;
    return broken;
}

// Registered before main, so that it runs after everything that the program registers.
static void check_end(void)
{
    if (it.loaded || it.open)
        breaks("the program ends without NiFpga_Close or NiFpga_Finalize");
}

__attribute__((constructor)) static void register_check_end(void) { atexit(check_end); }

// ---- a program without a VI ----

// If the program does not define the VI, any signature and any address is accepted, and the first access determines the type of a register.
__attribute__((weak)) const StandinVi standin_vi = {NULL, NULL, 0, false};
__attribute__((weak)) NiFpga_Status standin_before(StandinCall call, StandinRegister *r)
{
    (void)call;
    (void)r;
    return 0;
}

enum { ASSUMED = 64 };
static StandinRegister assumed[ASSUMED];
static unsigned assumed_count;

static StandinRegister *assume(uint32_t address, StandinType type, bool control)
{
    for (unsigned i = 0; i < assumed_count; i++)
        if (assumed[i].address == address)
            return &assumed[i];
    if (assumed_count == ASSUMED)
        return NULL;
    assumed[assumed_count] = (StandinRegister){address, (uint8_t)type, control, 0, 0, false};
    return &assumed[assumed_count++];
}

// ---- registers ----

StandinRegister *standin_find(uint32_t address)
{
    for (unsigned i = 0; i < standin_vi.count; i++)
        if (standin_vi.at[i].address == address)
            return &standin_vi.at[i];
    return NULL;
}

static StandinRegister *find(uint32_t address, StandinType type, bool control)
{
    return standin_vi.at ? standin_find(address) : assume(address, type, control);
}

static void set_defaults(void)
{
    for (unsigned i = 0; i < standin_vi.count; i++)
        standin_vi.at[i].value = 0, standin_vi.at[i].written = false;
}

void standin_reset(void)
{
    const NiFpga_Session session = it.session;

    memset(&it, 0, sizeof it);
    it.session = session;
    set_defaults();
}

void standin_inject(unsigned n, NiFpga_Status status) { it.until = n + 1, it.injected = status; }
unsigned standin_calls(void) { return it.calls; }
StandinCall standin_call(unsigned i) { return (StandinCall)it.kind[i]; }
void standin_slow(void) { it.slow = true; }
bool standin_runs(void) { return it.runs; }

// ---- every call ----

// Begins a call.  Returns the status that was injected for it, or that of standin_before.
static NiFpga_Status begin(StandinCall call, StandinRegister *r)
{
    const bool alone = call == STANDIN_Initialize || call == STANDIN_Finalize;
    NiFpga_Status status;

    pthread_mutex_lock(&guard);
    if (it.alone > 0 || (alone && it.inside > 0))
        breaks("a call overlaps with NiFpga_Initialize or NiFpga_Finalize");
    it.inside++;
    it.alone += alone;
    if (it.slow) {            // allows calls of other threads meanwhile
        pthread_mutex_unlock(&guard);
        sched_yield();
        pthread_mutex_lock(&guard);
    }
    if (it.calls < LOGGED)
        it.kind[it.calls] = (uint8_t)call;
    it.calls++;
    status = standin_before(call, r);
    if (it.until > 0 && --it.until == 0 && status == 0)
        status = it.injected;
    return status;
}

static NiFpga_Status end(StandinCall call, NiFpga_Status status)
{
    it.inside--;
    it.alone -= call == STANDIN_Initialize || call == STANDIN_Finalize;
    if (it.open && (status == invalid_session || status == rpc_session || status == not_initialized))
        it.lost = true;
    pthread_mutex_unlock(&guard);
    return status;
}

static void check_session(NiFpga_Session session)
{
    if (!it.loaded)
        breaks("a call before NiFpga_Initialize or after NiFpga_Finalize");
    else if (!it.open || session != it.session)
        breaks("the session is not open");
    else if (it.lost)
        breaks("the session was reported as invalid");
}

// ---- library and session ----

NiFpga_Status NiFpga_Initialize(void)
{
    const NiFpga_Status status = begin(STANDIN_Initialize, NULL);

    if (it.loaded)
        breaks("NiFpga_Initialize twice");
    it.loaded = it.loaded || status >= 0;
    it.lost = false;
    return end(STANDIN_Initialize, status);
}

NiFpga_Status NiFpga_Finalize(void)
{
    const NiFpga_Status status = begin(STANDIN_Finalize, NULL);

    if (!it.loaded)
        breaks("NiFpga_Finalize without NiFpga_Initialize");
    if (it.open && !it.lost)
        breaks("NiFpga_Finalize with an open session");
    it.loaded = it.open = false;
    return end(STANDIN_Finalize, status);
}

NiFpga_Status NiFpga_Open(const char *bitfile, const char *signature, const char *resource, uint32_t attribute, NiFpga_Session *session)
{
    NiFpga_Status status = begin(STANDIN_Open, NULL);

    if (!it.loaded)
        breaks("NiFpga_Open before NiFpga_Initialize");
    if (it.open)
        breaks("a second session");
    if (!bitfile || bitfile[0] != '/' || !signature || !resource || !session || attribute > 1)
        breaks("an argument of NiFpga_Open");
    else if (standin_vi.signature && strcmp(signature, standin_vi.signature) != 0)
        status = signature_mismatch;
    if (status >= 0) {
        it.open = true;
        *session = ++it.session;
        it.runs = it.runs || attribute == 0;
    }
    return end(STANDIN_Open, status);
}

NiFpga_Status NiFpga_Close(NiFpga_Session session, uint32_t attribute)
{
    const NiFpga_Status status = begin(STANDIN_Close, NULL);

    check_session(session);
    if (attribute > 1)
        breaks("an attribute of NiFpga_Close");
    it.open = false;
    if (attribute == 0) {
        it.runs = false;
        set_defaults();
    }
    return end(STANDIN_Close, status);
}

// A control that is first written after the start had another value before.
static void check_written(const StandinRegister *r)
{
    if (standin_vi.all_at_start && it.runs && !r->written)
        breaks("the VI was started before this control was written");
}

NiFpga_Status NiFpga_Run(NiFpga_Session session, uint32_t attribute)
{
    NiFpga_Status status = begin(STANDIN_Run, NULL);

    check_session(session);
    if (attribute != 0)
        breaks("an attribute of NiFpga_Run");
    if (status == 0 && it.runs)
        status = already_running;
    it.runs = it.runs || status >= 0 || status == already_running;
    return end(STANDIN_Run, status);
}

// ---- controls and indicators ----

static StandinRegister *check_access(NiFpga_Session session, StandinRegister *r, StandinType type, bool write)
{
    check_session(session);
    if (!r)
        breaks("no control or indicator has this address");
    else if (r->type != type)
        breaks("the control or indicator has another type");
    else if (write && !r->control)
        breaks("a write to an indicator");
    else
        return r;
    return NULL;
}

static double read_register(const StandinRegister *r)
{
    const StandinRegister *source = r->follows != 0 && it.runs ? standin_find(r->follows) : NULL;

    return source ? source->value : r->value;
}

#define ACCESS(name, c) \
    NiFpga_Status NiFpga_Read##name(NiFpga_Session session, uint32_t indicator, c *value) \
    { \
        StandinRegister *r = find(indicator, STANDIN_##name, false); \
        const NiFpga_Status status = begin(STANDIN_Read, r); \
        \
        r = check_access(session, r, STANDIN_##name, false); \
        if (!value) \
            breaks("a null pointer"); \
        else if (r && status >= 0) \
            *value = (c)read_register(r); \
        else \
            *value = (c)77;                   /* what a failed read leaves there must not be used */ \
        return end(STANDIN_Read, status); \
    } \
    NiFpga_Status NiFpga_Write##name(NiFpga_Session session, uint32_t control, c value) \
    { \
        StandinRegister *r = find(control, STANDIN_##name, true); \
        const NiFpga_Status status = begin(STANDIN_Write, r); \
        \
        r = check_access(session, r, STANDIN_##name, true); \
        if (r) \
            check_written(r); \
        if (r && status >= 0) { \
            r->value = (double)value; \
            r->written = true; \
        } \
        return end(STANDIN_Write, status); \
    }
ACCESS(Bool, NiFpga_Bool)
ACCESS(I8, int8_t)
ACCESS(U8, uint8_t)
ACCESS(I16, int16_t)
ACCESS(U16, uint16_t)
ACCESS(I32, int32_t)
ACCESS(U32, uint32_t)
ACCESS(I64, int64_t)
ACCESS(U64, uint64_t)
ACCESS(Sgl, float)
ACCESS(Dbl, double)
