// SPDX-License-Identifier: Apache-2.0
// The guarantees of the sbRIO platform beyond the headers, on the stand-in for NI's library: types and scales, the order of calls, every
// documented status at every call, a lost session, threads, the end of the program.
#define _GNU_SOURCE
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "NiFpga_Suite.h"
#include "runtime-c/io.h"
#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/dio.h"
#include "runtime-c/psl/sbrio/fpga.h"
#include "tests/psl/suite.h"
#include "tests/sbrio/NiFpga_standin.h"

static StandinRegister *of(uint32_t address) { return standin_find(address); }

static PalAio open_channel(uint16_t number, PalAioMode mode)
{
    PalAio channel = {0};

    CHECK(pal_aio_open(&channel, number, mode) == SM_OK);
    return channel;
}

static PalDio open_pin(uint16_t number, PalDioMode mode, bool level)
{
    PalDio pin = {0};

    CHECK(pal_dio_open(&pin, number, mode, level) == SM_OK);
    return pin;
}

// ---- types ----

// Returns what the indicator measures when a channel has this output: the nearest value of the type.
static const struct { SbrioType type; int32_t out, in; } samples[] = {
    {SBRIO_I8, 0, 0}, {SBRIO_I8, 149999, 100000}, {SBRIO_I8, 150001, 200000}, {SBRIO_I8, -150001, -200000}, {SBRIO_I8, 99000000, 12700000},
    {SBRIO_I8, -99000000, -12800000}, {SBRIO_U8, -1000000, -1000000}, {SBRIO_U8, 500000, 500000}, {SBRIO_U8, 9000000, 1550000}, {SBRIO_U8, -9000000, -1000000},
    {SBRIO_I16, 1000, 1000}, {SBRIO_I16, -32767000, -32767000}, {SBRIO_I16, 32768000, 32768000}, {SBRIO_I16, 40000000, 32768000},
    {SBRIO_U16, 65535000, 65535000}, {SBRIO_U16, -1000, 0}, {SBRIO_U16, 70000000, 65535000}, {SBRIO_I32, INT32_MAX, INT32_MAX},
    {SBRIO_I32, INT32_MIN, INT32_MIN}, {SBRIO_I32, -1, -1}, {SBRIO_U32, INT32_MAX, INT32_MAX}, {SBRIO_U32, -1, 0}, {SBRIO_I64, INT32_MIN, INT32_MIN},
    {SBRIO_I64, 7, 7}, {SBRIO_U64, INT32_MAX, INT32_MAX}, {SBRIO_U64, -5, 0}, {SBRIO_Sgl, 2500000, 2500000}, {SBRIO_Sgl, -1, -1},
    {SBRIO_Dbl, 1234567, 1234567}, {SBRIO_Dbl, INT32_MIN, INT32_MIN},
};

static const struct { SbrioType type; PalAioInfo info; } infos[] = {
    {SBRIO_I8, {-12800000, 12700000, 100000}}, {SBRIO_U8, {-1000000, 1550000, 10000}}, {SBRIO_I16, {-32767000, 32768000, 1000}},
    {SBRIO_U16, {0, 65535000, 1000}}, {SBRIO_I32, {INT32_MIN, INT32_MAX, 1}}, {SBRIO_U32, {0, INT32_MAX, 1}}, {SBRIO_I64, {INT32_MIN, INT32_MAX, 0}},
    {SBRIO_U64, {0, INT32_MAX, 0}}, {SBRIO_Sgl, {INT32_MIN, INT32_MAX, 0}}, {SBRIO_Dbl, {INT32_MIN, INT32_MAX, 0}},
};

static void test_types(void)
{
    for (size_t i = 0; i < COUNT(samples); i++) {
        const PalAio out = open_channel((uint16_t)(20 + samples[i].type), PAL_AIO_OUTPUT), in = open_channel((uint16_t)(40 + samples[i].type), PAL_AIO_INPUT);
        int32_t x = 99;

        CHECK(pal_aio_write(out, samples[i].out) == SM_OK && pal_aio_read(in, &x) == SM_OK);
        CHECK(x == samples[i].in);
        CHECK(pal_aio_close(out) == SM_OK && pal_aio_close(in) == SM_OK);
    }
    for (size_t i = 0; i < COUNT(infos); i++) {
        const PalAio in = open_channel((uint16_t)(40 + infos[i].type), PAL_AIO_INPUT);
        PalAioInfo info = {1, 1, 1};

        CHECK(pal_aio_info(in, &info) == SM_OK && memcmp(&info, &infos[i].info, sizeof info) == 0);
        CHECK(pal_aio_close(in) == SM_OK);
    }
}

// An indicator that is NaN has no measurement; infinities saturate.
static void test_not_finite(void)
{
    const PalAio in = open_channel(40 + SBRIO_Sgl, PAL_AIO_INPUT);
    StandinRegister *r = of(NiFpga_Suite_ControlSgl_Out);
    int32_t x = 7;

    r->value = NAN;
    CHECK(pal_aio_read(in, &x) == SM_E_DEVICE && x == 7);
    r->value = (double)INFINITY;
    CHECK(pal_aio_read(in, &x) == SM_OK && x == INT32_MAX);
    r->value = (double)-INFINITY;
    CHECK(pal_aio_read(in, &x) == SM_OK && x == INT32_MIN);
    r->value = 0;
    CHECK(pal_aio_close(in) == SM_OK);
}

// ---- rows and modes ----

static void test_modes(void)
{
    static const struct { uint16_t number; PalDioMode mode; SmResult expected; } opens[] = {
        {4, PAL_DIO_INPUT, SM_E_UNSUPPORTED}, {4, PAL_DIO_PULL_UP, SM_E_UNSUPPORTED}, {5, PAL_DIO_OUTPUT, SM_E_UNSUPPORTED},
        {5, PAL_DIO_PULL_UP, SM_E_UNSUPPORTED}, {5, PAL_DIO_PULL_DOWN, SM_E_UNSUPPORTED}, {6, PAL_DIO_PULL_UP, SM_OK}, {6, PAL_DIO_PULL_DOWN, SM_E_UNSUPPORTED},
        {6, PAL_DIO_INPUT, SM_OK}, {7, PAL_DIO_PULL_DOWN, SM_OK}, {7, PAL_DIO_PULL_UP, SM_E_UNSUPPORTED}, {1, PAL_DIO_INPUT, SM_E_MISSING}};
    PalAio channel = {0};

    for (size_t i = 0; i < COUNT(opens); i++) {
        PalDio pin = {0};

        CHECK(pal_dio_open(&pin, opens[i].number, opens[i].mode, false) == opens[i].expected && (pin.id != 0) == (opens[i].expected == SM_OK));
        CHECK(pin.id == 0 || pal_dio_close(pin) == SM_OK);
    }
    CHECK(pal_aio_open(&channel, 0, PAL_AIO_INPUT) == SM_E_UNSUPPORTED && pal_aio_open(&channel, 1, PAL_AIO_OUTPUT) == SM_E_UNSUPPORTED);
    for (uint16_t number = 60; number < 64; number++)
        CHECK(pal_aio_open(&channel, number, PAL_AIO_INPUT) == SM_E_ARGUMENT && channel.id == 0);
    CHECK(pal_aio_open(&channel, 5, PAL_AIO_INPUT) == SM_E_MISSING);                  // a digital pin
}

// ---- the start of the VI ----

static void test_start(void)
{
    PalDio out, in;
    PalAio analog;
    bool level = false;

    standin_reset();
    out = open_pin(4, PAL_DIO_OUTPUT, true);
    in = open_pin(5, PAL_DIO_INPUT, false);
    analog = open_channel(0, PAL_AIO_OUTPUT);
    CHECK(pal_aio_write(analog, 1000000) == SM_OK);
    CHECK(!standin_runs() && of(NiFpga_Suite_ControlBool_Out)->value == 1 && of(NiFpga_Suite_ControlI16_Out)->value == 3200);
    CHECK(pal_dio_read(in, &level) == SM_OK && level && standin_runs());
    CHECK(pal_dio_close(out) == SM_OK && pal_dio_close(in) == SM_OK && pal_aio_close(analog) == SM_OK);
    CHECK(standin_runs() && of(NiFpga_Suite_ControlBool_Out)->value == 1);            // closing changes no output

    out = open_pin(4, PAL_DIO_OUTPUT, true);                                          // the VI is already running
    CHECK(pal_dio_write(out, false) == SM_OK && of(NiFpga_Suite_ControlBool_Out)->value == 0 && pal_dio_close(out) == SM_OK);

    standin_reset();
    out = open_pin(4, PAL_DIO_OUTPUT, false);
    CHECK(!standin_runs() && pal_dio_write(out, true) == SM_OK && standin_runs() && pal_dio_close(out) == SM_OK);
    standin_reset();
    analog = open_channel(0, PAL_AIO_OUTPUT);
    CHECK(pal_aio_write(analog, 5) == SM_OK && !standin_runs() && pal_aio_write(analog, 5) == SM_OK && standin_runs());
    CHECK(pal_aio_close(analog) == SM_OK);
}

// ---- every status at every call ----

enum { OUT_ANALOG, OUT_DIGITAL, IN_ANALOG = 0, IN_DIGITAL };
enum { TICKS = 3, INIT_CALLS = 4, CALLS_OF_TICK = 4 };
static uint64_t elements[4];
static const SmLayout layout = {.whole = {.size = sizeof elements}};
static SmStateVec vector = {&layout, elements, false, {0}, 0};
static const SmIoPin output_rows[] = {{SM_ANALOG_OUT, SM_I32, 0, 0, 0, 0, 0x3FF0000000000000u, 0, 0}, {SM_DIGITAL_OUT, SM_BOOL, 0, 0, 4, 4, 0, 0, 0}};
static const SmIoPin input_rows[] = {{SM_ANALOG_IN, SM_F32, 0, 0, 1, 8, 0x3FF0000000000000u, 0, 0}, {SM_DIGITAL_IN, SM_BOOL, 0, 0, 5, 12, 0, 0, 0}};

typedef struct Run {
    SmResult opened, inputs[TICKS], outputs[TICKS];
    float analog[TICKS];      // the elements of the inputs after each tick
    bool digital[TICKS];
    uint16_t missed[TICKS][2];
    unsigned calls;
} Run;

static const SmTick no_tick = {0, 0};

static void set_elements(int32_t analog, bool digital)
{
    memcpy(elements, &analog, sizeof analog);
    memcpy((char *)elements + 4, &digital, sizeof digital);
}

// Runs three ticks of an application with two outputs, and two inputs connected to them.  Call number `at` returns `status`.
static Run run_with(unsigned at, NiFpga_Status status)
{
    static uint8_t handles[2][2];
    static uint16_t missed[2][2];
    static uint64_t values[2][2];
    SmIo out = {output_rows, 2, &vector, handles[0], missed[0], values[0], 0}, in = {input_rows, 2, &vector, handles[1], missed[1], values[1], 0};
    Run run;

    memset(&run, 0, sizeof run);
    memset(elements, 0, sizeof elements);
    standin_reset();
    if (status != 0)
        standin_inject(at, status);
    run.opened = sm_outputs_init(&out);
    if (run.opened != SM_OK) {
        run.calls = standin_calls();
        return run;
    }
    CHECK(sm_inputs_init(&in) == SM_OK);
    for (int i = 0; i < TICKS; i++) {
        run.inputs[i] = sm_inputs_step(&in, &no_tick);
        memcpy(&run.analog[i], (const char *)elements + 8, sizeof run.analog[i]);
        memcpy(&run.digital[i], (const char *)elements + 12, sizeof run.digital[i]);
        set_elements(i + 1, true);
        run.outputs[i] = sm_outputs_step(&out, &no_tick);
        memcpy(run.missed[i], missed[0], sizeof run.missed[i]);
    }
    sm_inputs_close(&in);
    sm_outputs_close(&out);
    run.calls = standin_calls();
    return run;
}

static bool is_clean(const Run *r, int from)
{
    bool good = true;

    for (int i = from; i < TICKS; i++)
        good = good && r->inputs[i] == SM_OK && r->outputs[i] == SM_OK && r->analog[i] == (float)i && r->digital[i] == (i > 0) && r->missed[i][0] == 0 && r->missed[i][1] == 0;
    return good;
}

// After a session was lost, no value is read or written, every element is invalid, and the only further call is NiFpga_Finalize.
static void check_lost(const Run *r, unsigned at, int from)
{
    for (int i = from; i < TICKS; i++)
        CHECK(r->inputs[i] == SM_E_CLOSED && r->outputs[i] == SM_E_CLOSED && isnan(r->analog[i]) && !r->digital[i] && r->missed[i][0] > 0 && r->missed[i][1] > 0);
    CHECK(r->calls == at + 2 && standin_call(at + 1) == STANDIN_Finalize);
}

// `n` is the number of the call in tick i: reads of the two inputs, writes of the two outputs.
static void check_tick(const Run *r, unsigned at, int i, unsigned n, SmResult expected)
{
    const bool lost = expected == SM_E_CLOSED;

    CHECK((n < 2 ? r->inputs[i] : r->outputs[i]) == expected);
    CHECK(n != IN_ANALOG || isnan(r->analog[i]));
    CHECK(n != IN_DIGITAL || !r->digital[i]);
    CHECK(n == IN_ANALOG || r->analog[i] == (float)i);
    CHECK(lost || n == IN_DIGITAL || r->digital[i] == (i > 0));
    CHECK(lost || n < 2 || (r->missed[i][n - 2] == 1 && r->missed[i][3 - n] == 0));
    if (lost)
        check_lost(r, at, i + 1);
    else if (n < 2)
        CHECK(is_clean(r, i + 1));
    else if (i + 1 < TICKS) {                             // the input shows the old value; the next tick writes again
        CHECK(r->inputs[i + 1] == SM_OK && r->outputs[i + 1] == SM_OK && r->missed[i + 1][0] == 0 && r->missed[i + 1][1] == 0);
        CHECK(r->analog[i + 1] == (float)(n == 2 + OUT_ANALOG ? i : i + 1) && r->digital[i + 1] == (n == 2 + OUT_ANALOG || i > 0));
        CHECK(is_clean(r, i + 2));
    }
}

static void check_run(unsigned at, NiFpga_Status status, SmResult expected, unsigned calls)
{
    const Run r = run_with(at, status);
    const unsigned of_tick = at - INIT_CALLS - 1;         // the calls of the start precede the run of the VI

    if (at < INIT_CALLS)
        CHECK(r.opened == expected);
    else if (at == INIT_CALLS && status == -61003)
        CHECK(is_clean(&r, 0));
    else if (at == INIT_CALLS && expected == SM_E_CLOSED)
        check_lost(&r, at, 0);
    else if (at == INIT_CALLS)                            // opening the next pin runs the VI
        CHECK(r.inputs[0] == expected && isnan(r.analog[0]) && !r.digital[0] && r.outputs[0] == SM_OK && is_clean(&r, 1));
    else if (of_tick < TICKS * CALLS_OF_TICK)
        check_tick(&r, at, (int)(of_tick / CALLS_OF_TICK), of_tick % CALLS_OF_TICK, expected);
    else
        CHECK(is_clean(&r, 0));
    CHECK(sbrio_last_error() == status || (at >= INIT_CALLS + 1 + TICKS * CALLS_OF_TICK) || status == -61003);
    CHECK(r.calls <= calls + 1);
}

static const struct { NiFpga_Status status; SmResult result; } statuses[] = {
#define SBRIO_STATUS(name, number, result) {number, result},
#include "runtime-c/psl/sbrio/status.def"
#undef SBRIO_STATUS
    {-1, SM_E_DEVICE}, {-99999, SM_E_DEVICE},             // status codes that are not documented
    {-52006, SM_E_MISSING}, {-52010, SM_E_CLOSED}, {-61252, SM_E_BUSY}, {-63033, SM_E_DENIED}, {-63043, SM_E_CLOSED}, {-63101, SM_E_MISSING},
    {-63106, SM_E_UNSUPPORTED}, {-63150, SM_E_DEVICE}, {-63192, SM_E_MISSING}, {-63195, SM_E_CLOSED}, {-63198, SM_E_FULL},          // not in the table
};

static void test_statuses(void)
{
    const Run clean = run_with(0, 0);
    unsigned injected = 0;

    CHECK(clean.opened == SM_OK && is_clean(&clean, 0) && clean.calls == INIT_CALLS + 1 + TICKS * CALLS_OF_TICK + 4);
    for (size_t i = 0; i < COUNT(statuses); i++)
        for (unsigned at = 0; at < clean.calls; at++) {
            Run warned;

            check_run(at, statuses[i].status, statuses[i].result, clean.calls);
            warned = run_with(at, -statuses[i].status);   // a warning: the call succeeds
            CHECK(warned.opened == SM_OK && is_clean(&warned, 0) && warned.calls == clean.calls);
            injected += 2;
        }
    CHECK(injected == COUNT(statuses) * clean.calls * 2 && COUNT(statuses) >= 63);
}

// ---- a lost session ----

static void test_lost(void)
{
    PalDio pin, other = {0};
    PalAio channel, unwritten;
    bool level = true;
    int32_t x = 7;
    unsigned calls;

    standin_reset();
    pin = open_pin(4, PAL_DIO_OUTPUT, true);
    channel = open_channel(1, PAL_AIO_INPUT);
    unwritten = open_channel(0, PAL_AIO_OUTPUT);
    CHECK(pal_aio_read(channel, &x) == SM_OK);
    standin_inject(0, -63195);
    CHECK(pal_dio_write(pin, false) == SM_E_CLOSED && sbrio_last_error() == -63195);
    calls = standin_calls();
    x = 7;
    CHECK(pal_aio_read(channel, &x) == SM_E_CLOSED && x == 7 && pal_dio_read(pin, &level) == SM_E_CLOSED && level);
    CHECK(pal_aio_write(unwritten, 5) == SM_E_CLOSED && pal_dio_write(pin, true) == SM_E_CLOSED);
    CHECK(pal_dio_open(&other, 5, PAL_DIO_INPUT, false) == SM_E_CLOSED && other.id == 0);
    CHECK(standin_calls() == calls);                      // no call reached the library, not even to open a session
    CHECK(pal_dio_close(pin) == SM_OK && pal_aio_close(channel) == SM_OK && pal_aio_close(unwritten) == SM_OK);
    pin = open_pin(4, PAL_DIO_OUTPUT, true);              // opens a new session
    CHECK(pal_dio_read(pin, &level) == SM_OK && level && pal_dio_close(pin) == SM_OK);
}

// ---- threads ----

static void *open_and_close(void *number)
{
    int32_t x;

    for (int i = 0; i < 300; i++) {
        PalAio channel = {0};

        if (pal_aio_open(&channel, *(const uint16_t *)number, PAL_AIO_INPUT) != SM_OK || pal_aio_read(channel, &x) != SM_OK || pal_aio_close(channel) != SM_OK)
            return NULL;
    }
    return number;
}

// Threads with a pin each: no call overlaps with the loading or unloading of the library.
static void test_threads(void)
{
    static uint16_t numbers[] = {1, 40 + SBRIO_U8, 40 + SBRIO_I32};
    pthread_t threads[COUNT(numbers)];
    void *result;

    standin_reset();
    standin_slow();
    for (size_t i = 0; i < COUNT(numbers); i++)
        CHECK(pthread_create(&threads[i], NULL, open_and_close, &numbers[i]) == 0);
    for (size_t i = 0; i < COUNT(numbers); i++)
        CHECK(pthread_join(threads[i], &result) == 0 && result == &numbers[i]);
    CHECK(standin_calls() > 900);
    standin_reset();
}

// ---- the end of the program ----

static int code_of_child(void (*child)(void))
{
    int status = 0;
    pid_t pid;

    fflush(NULL);
    pid = fork();
    if (pid == 0) {
        if (!freopen("/dev/null", "w", stderr))
            _exit(4);
        child();
        exit(0);
    }
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid && WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void end_with_open_pin(void) { open_pin(4, PAL_DIO_OUTPUT, true); }
static void end_with_library(void) { NiFpga_Initialize(); }
static void end_after_loss(void)
{
    PalDio pin = open_pin(4, PAL_DIO_OUTPUT, true);

    standin_inject(0, -63195);
    CHECK(pal_dio_write(pin, false) == SM_E_CLOSED);
}

// ---- the stand-in itself ----

#define BREAKS(...) (standin_expect_broken(), (void)(__VA_ARGS__), standin_broken())

static void test_standin(void)
{
    const char *signature = NiFpga_Suite_Signature;
    NiFpga_Session session = 0;
    NiFpga_Bool level;
    int16_t x;

    standin_reset();
    CHECK(BREAKS(NiFpga_Open("/a", signature, "RIO0", 1, &session)) && BREAKS(NiFpga_Finalize()) && BREAKS(NiFpga_ReadBool(session, NiFpga_Suite_IndicatorBool_In, &level)));
    standin_reset();
    CHECK(!BREAKS(NiFpga_Initialize()) && BREAKS(NiFpga_Initialize()));
    CHECK(BREAKS(NiFpga_Open("a", signature, "RIO0", 1, &session)));
    standin_reset();
    CHECK(NiFpga_Initialize() == 0 && NiFpga_Open("/a", "another", "RIO0", 1, &session) == -63106 && NiFpga_Open("/a", signature, "RIO0", 1, &session) == 0);
    CHECK(!BREAKS(NiFpga_ReadBool(session, NiFpga_Suite_IndicatorBool_In, &level)) && BREAKS(NiFpga_ReadBool(session + 1, NiFpga_Suite_IndicatorBool_In, &level)));
    CHECK(BREAKS(NiFpga_ReadI16(session, NiFpga_Suite_IndicatorBool_In, &x)) && BREAKS(NiFpga_ReadBool(session, 1, &level)));
    CHECK(BREAKS(NiFpga_WriteBool(session, NiFpga_Suite_IndicatorBool_In, 1)) && BREAKS(NiFpga_ReadBool(session, NiFpga_Suite_IndicatorBool_In, NULL)));
    CHECK(NiFpga_Run(session, 0) == 0 && NiFpga_Run(session, 0) == -61003 && BREAKS(NiFpga_Run(session, 2)) && BREAKS(NiFpga_Finalize()));
    standin_reset();
    CHECK(code_of_child(end_with_library) == 3 && code_of_child(end_with_open_pin) == 0 && code_of_child(end_after_loss) == 0);
    standin_reset();
}

Tally own_sbrio(void)
{
    test_types();
    test_not_finite();
    test_modes();
    test_start();
    test_statuses();
    test_lost();
    test_threads();
    test_standin();
    return TALLY();
}
