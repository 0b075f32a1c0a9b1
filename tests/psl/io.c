// SPDX-License-Identifier: Apache-2.0
// Runs runtime-c/io.h on the pins of the platform: one pin reads what another one outputs.
#include "runtime-c/io.h"

#include "tests/psl/suite.h"

// Bits of numbers.
#define ONE  0x3FF0000000000000u
#define TWO  0x4000000000000000u
#define FIVE 0x4014000000000000u
#define TEN  0x4024000000000000u
#define MINUS 0x8000000000000000u

enum { HEATER = 0, PRESSURE = 8, VALVE = 16, LIMIT = 17 };

static uint64_t elements[3];
static const SmLayout layout = {.whole = {.size = sizeof elements}};
static SmStateVec vector = {&layout, elements, false, {0}, 0};
static const SmTick tick = {0, 0};

static void set_double(unsigned at, double x) { memcpy((char *)elements + at, &x, sizeof x); }

static double get_double(unsigned at)
{
    double x;

    memcpy(&x, (const char *)elements + at, sizeof x);
    return x;
}

static uint8_t *get_bool(unsigned at) { return (uint8_t *)elements + at; }

static SmIo table_of(const SmIoPin *row, uint16_t n)
{
    static uint8_t handle[2];
    static uint16_t missed[2];
    static uint64_t value[2];
    SmIo io = {row, n, &vector, handle, missed, value, 9};

    return io;
}

// The output is (element - 1) / 2 volts, and 2 V in the safe state.  The input is volts * 10 - 5.
static void test_analog(void)
{
    const SmIoPin row[] = {{SM_ANALOG_OUT, SM_F64, 0, 0, bench.channel_out, HEATER, TWO, ONE, FIVE},
                           {SM_ANALOG_IN, SM_F64, 0, 0, bench.channel_in, PRESSURE, TEN, FIVE | MINUS, 0}};
    SmIo io = table_of(row, 2);

    if (bench.aio == HAS_NONE)
        CHECK(sm_outputs_init(&io) == SM_E_UNSUPPORTED && io.failed == 0);
    if (bench.aio != HAS)
        return;
    CHECK(sm_outputs_init(&io) == SM_OK && sm_inputs_init(&io) == SM_OK);
    CHECK(sm_inputs_step(&io, &tick) == SM_OK);
    CHECK(!bench.analog_wired || get_double(PRESSURE) == 15);             // the safe value, from the start
    set_double(HEATER, 3);
    CHECK(sm_outputs_step(&io, &tick) == SM_OK && sm_inputs_step(&io, &tick) == SM_OK);
    CHECK(!bench.analog_wired || get_double(PRESSURE) == 5);
    sm_inputs_close(&io);
    sm_outputs_close(&io);
    CHECK(sm_outputs_init(&io) == SM_OK && sm_inputs_init(&io) == SM_OK); // the pins were closed
    CHECK(sm_inputs_step(&io, &tick) == SM_OK && (!bench.analog_wired || get_double(PRESSURE) == 15));
    sm_inputs_close(&io);
    sm_outputs_close(&io);
}

static void test_digital(void)
{
    const SmIoPin row[] = {{SM_DIGITAL_OUT, SM_BOOL, 0, 0, bench.pins[0], VALVE, 0, 0, ONE},
                           {SM_DIGITAL_IN, SM_BOOL, SM_IO_INVERTED, 0, bench.pins[1], LIMIT, 0, 0, 0}};
    SmIo io = table_of(row, 2);

    if (bench.dio == HAS_NONE)
        CHECK(sm_outputs_init(&io) == SM_E_UNSUPPORTED && io.failed == 0);
    if (bench.dio != HAS)
        return;
    CHECK(sm_outputs_init(&io) == SM_OK && sm_inputs_init(&io) == SM_OK);
    CHECK(sm_inputs_step(&io, &tick) == SM_OK && (!bench.wired || *get_bool(LIMIT) == 0));
    *get_bool(VALVE) = 0;
    CHECK(sm_outputs_step(&io, &tick) == SM_OK && sm_inputs_step(&io, &tick) == SM_OK);
    CHECK(!bench.wired || *get_bool(LIMIT) == 1);
    sm_inputs_close(&io);
    sm_outputs_close(&io);
}

// A missing pin makes the start fail, and the error contains its number.
static void test_missing(void)
{
    const SmIoPin row[] = {{SM_ANALOG_IN, SM_F64, 0, 0, bench.channel_in, PRESSURE, ONE, 0, 0},
                           {SM_ANALOG_IN, SM_F64, 0, 0, bench.channel_missing, PRESSURE, ONE, 0, 0}};
    SmIo io = table_of(row, 2);

    if (bench.aio != HAS)
        return;
    CHECK(sm_inputs_init(&io) == SM_E_MISSING && io.failed == 1);
    CHECK(sm_inputs_init(&io) == SM_E_MISSING && io.failed == 1);
}

Tally contract_io(void)
{
    test_analog();
    test_digital();
    test_missing();
    return TALLY();
}
