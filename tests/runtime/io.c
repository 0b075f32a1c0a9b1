// SPDX-License-Identifier: Apache-2.0
// Inputs and outputs (runtime-c/io.h) of tests/runtime/pins.io in the simulation: arithmetic, pins that fail, safe values, the
// critical section.
// clause 9.7 clause 9.8 clause 9.9 clause 9.10 clause 9.11
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "pins_io.h"
#include "pins.h"
#include "images.h"
#include "bytecode-vm/target/io.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/convert.h"
#include "tests/test.h"

static const SmTick tick = {0, 0};

static SmIo *const in = &pins_inputs, *const out = &pins_outputs;
static SmStateVec *const sv = &pins_vector;

// Resets time, pins, lock and vector.  No pin is open.
static void renew(bool guarded)
{
    sim_reset();
    memset(&pins_sv, 0, sizeof pins_sv);
    sv->guarded = guarded;
    CHECK(sm_statevec_init(sv) == SM_OK);
}

static void start(bool guarded)
{
    renew(guarded);
    CHECK(sm_inputs_init(in) == SM_OK && sm_outputs_init(out) == SM_OK);
}

static SmResult step_in(void) { return sm_inputs_step(in, &tick); }
static SmResult step_out(void) { return sm_outputs_step(out, &tick); }

// ---- inputs ----

static void test_inputs(bool guarded)
{
    start(guarded);
    sim_set_analog(0, 1000000);
    sim_set_analog(1, -2500000);
    sim_set_analog(2, 1000000);
    sim_set_analog(3, 1999);
    sim_set_analog(4, 1000000);
    sim_drive(10, false);
    sim_drive(11, false);
    sim_drive(12, true);
    CHECK(step_in() == SM_OK);
    CHECK(pins_sv.pressure == 125.0);
    CHECK(pins_sv.flow == 0.25f);
    CHECK(pins_sv.small == 127);                  // saturates
    CHECK(pins_sv.count == 1);                    // 1.995: the fraction is removed
    CHECK(pins_sv.wide == INT64_MAX);
    CHECK(pins_sv.limit == 1 && pins_sv.door == 0 && pins_sv.float_ == 1);
    sim_set_analog(2, -1000000);
    CHECK(step_in() == SM_OK && pins_sv.small == -128);
}

// An open pin reads the level of its resistor.
static void test_pulls(void)
{
    start(true);
    CHECK(step_in() == SM_OK);
    CHECK(pins_sv.limit == 0 && pins_sv.door == 1 && pins_sv.float_ == 0);
}

// Volts are the integer of microvolts divided by 1000000, rounded once.  Then they are multiplied by the scale, rounded, and the offset is
// added, rounded.
static void test_input_arithmetic(void)
{
    unsigned seed = 1;

    start(true);
    for (int i = 0; i < 20000; i++) {
        int32_t micro;
        seed = seed * 1103515245u + 12345u;
        micro = (int32_t)((seed >> 8) % 20000001u) - 10000000;
        micro = micro / 5 * 5;                    // the resolution of the simulated channel
        sim_set_analog(0, micro);
        (void)step_in();
        CHECK(pins_sv.pressure == (double)micro / 1e6 * 250.0 + -125.0);
    }
}

// ---- what goes out ----

static void test_outputs(bool guarded)
{
    start(guarded);
    pins_sv.heater = 6.0;
    pins_sv.fan = 255;
    pins_sv.valve = 1;
    pins_sv.vent = 1;
    CHECK(step_out() == SM_OK);
    CHECK(sim_analog(5) == 1000000 && sim_analog(6) == 2550000 && sim_analog(7) == 6000000);      // two outputs of one element
    CHECK(sim_pin(20) && !sim_pin(21) && !sim_pin(22));
    pins_sv.valve = 0;
    pins_sv.vent = 0;
    CHECK(step_out() == SM_OK);
    CHECK(!sim_pin(20) && sim_pin(21) && sim_pin(22));
}

// Returns the output of channel 7, whose scale is 1: up to ±10 V in steps of 5 microvolts.
static int32_t micro_of(double heater)
{
    pins_sv.heater = heater;
    (void)step_out();
    return sim_analog(7);
}

static void test_output_arithmetic(void)
{
    start(true);
    CHECK(micro_of(0.0000125) == 10);             // 12.5: rounded to 13, then to a multiple of 5
    CHECK(micro_of(0.0000145) == 15);             // 14.5: rounded to 15, since halves are rounded away from 0
    CHECK(micro_of(-0.0000145) == -15);
    CHECK(micro_of(0.0000144) == 10);
    CHECK(micro_of(-0.0000144) == -10);
    CHECK(micro_of(1e300) == 10000000);           // the limit of the channel
    CHECK(micro_of(-1e300) == -10000000);
    CHECK(micro_of(INFINITY) == 10000000);
    CHECK(micro_of(NAN) == 0);                    // a stored NaN reads as 0
}

// Every step sets every output, whether it has changed or not.
static void test_outputs_each_step(void)
{
    uint32_t before;

    start(true);
    CHECK(step_out() == SM_OK);
    before = sim_count(SIM_dio_write) + sim_count(SIM_aio_write);
    CHECK(step_out() == SM_OK);
    CHECK(sim_count(SIM_dio_write) + sim_count(SIM_aio_write) == before + out->pins);
}

// ---- safe ----

static bool is_safe(void)
{
    return sim_analog(5) == 2000000 && sim_analog(6) == 500000 && sim_analog(7) == 0 && sim_pin(20) && sim_pin(21) && !sim_pin(22);
}

static void test_safe(void)
{
    renew(true);
    CHECK(sm_outputs_init(out) == SM_OK && is_safe());            // before the first step
    CHECK(sim_count_pin_changes(20) == 1 && sim_count_pin_changes(22) == 0);              // without a pulse
    pins_sv.heater = 1;
    pins_sv.vent = 1;
    CHECK(step_out() == SM_OK && !is_safe());
    CHECK(sm_outputs_safe(out, &tick) == SM_OK && is_safe());
    CHECK(pins_sv.heater == 1.0 && pins_sv.vent == 1);            // the elements are not changed
    CHECK(step_out() == SM_OK && !is_safe());
    sm_outputs_close(out);
    CHECK(is_safe());
    CHECK(sm_outputs_init(out) == SM_OK);                         // the pins were closed, so they can be opened again
}

// An output that cannot be made safe does not prevent this for the others.
static void test_safe_failing(void)
{
    start(true);
    pins_sv.heater = 6;
    CHECK(step_out() == SM_OK);
    sim_fail(SIM_aio_write, 0, SM_E_DEVICE);
    CHECK(sm_outputs_safe(out, &tick) == SM_E_DEVICE && out->failed == 0);
    CHECK(sim_analog(5) == 1000000 && sim_analog(6) == 500000 && sim_pin(20));
    CHECK(sm_outputs_safe(out, &tick) == SM_OK && is_safe());
}

// ---- pins that fail ----

static void test_hold(void)
{
    start(true);
    sim_set_analog(0, 2000000);
    sim_set_analog(1, 1000000);
    CHECK(step_in() == SM_OK && pins_sv.pressure == 375.0);
    sim_break(SIM_aio_read, 0, SM_E_DEVICE);
    CHECK(step_in() == SM_E_DEVICE);
    CHECK(pins_sv.pressure == 375.0 && isnan(pins_sv.flow));      // with hold; without hold
    CHECK(pins_sv.small == 0);                                    // an integer cannot be NaN
    CHECK(step_in() == SM_E_DEVICE && pins_sv.pressure == 375.0 && in->missed[0] == 2);
    CHECK(step_in() == SM_E_DEVICE && isnan(pins_sv.pressure));
    sim_break(SIM_aio_read, 0, SM_OK);
    CHECK(step_in() == SM_OK && pins_sv.pressure == 375.0 && in->missed[0] == 0);
    sim_break(SIM_aio_read, 0, SM_E_DEVICE);
    CHECK(step_in() == SM_E_DEVICE && pins_sv.pressure == 375.0); // the count of failed steps begins at 0 again
}

// 255 failed steps hold the value, and the 256th does not.  The count does not increase beyond 255.
static void test_long_hold(void)
{
    start(true);
    sim_set_analog(3, 5000000);
    CHECK(step_in() == SM_OK && pins_sv.count == 5000);
    sim_break(SIM_aio_read, 0, SM_E_DEVICE);
    for (int i = 0; i < 255; i++) {
        (void)step_in();
        CHECK(pins_sv.count == 5000);
    }
    (void)step_in();
    CHECK(pins_sv.count == 0);
    for (int i = 0; i < 70000; i++)
        (void)step_in();
    CHECK(in->missed[3] == UINT16_MAX && pins_sv.count == 0);
}

static void test_digital_failing(void)
{
    start(true);
    sim_drive(10, false);
    sim_drive(12, true);
    CHECK(step_in() == SM_OK && pins_sv.limit == 1 && pins_sv.float_ == 1);
    sim_break(SIM_dio_read, 0, SM_E_DEVICE);
    CHECK(step_in() == SM_E_DEVICE && pins_sv.limit == 1 && pins_sv.float_ == 0);
    CHECK(step_in() == SM_E_DEVICE && pins_sv.limit == 0);        // false, although the pin is inverted
    CHECK(in->pin[in->failed].pin == 12);                         // the last pin that failed
}

// If several pins fail, the first result is returned, and the others are still read.
static void test_one_failing(void)
{
    start(true);
    sim_set_analog(1, 1000000);
    sim_set_analog(3, 7000);
    sim_fail(SIM_aio_read, 1, SM_E_TIMEOUT);
    CHECK(step_in() == SM_E_TIMEOUT && in->pin[in->failed].pin == 1);
    CHECK(isnan(pins_sv.flow) && pins_sv.count == 7);
    pins_sv.heater = 6;
    sim_fail(SIM_aio_write, 0, SM_E_DEVICE);
    CHECK(step_out() == SM_E_DEVICE && out->pin[out->failed].pin == 5);
    CHECK(sim_analog(5) == 2000000 && sim_analog(7) == 6000000);
    CHECK(step_out() == SM_OK && sim_analog(5) == 1000000);
}

// ---- the start ----

// Whichever call fails, the pin is reported, no pin stays open, and outputs that were open are safe.
static void test_refused(SimCall call, SmIo *io, SmResult (*init)(void *io))
{
    uint32_t calls;

    renew(true);
    CHECK(init(io) == SM_OK);
    calls = sim_count(call);
    CHECK(calls > 0);
    for (uint32_t n = 0; n < calls; n++) {
        renew(true);
        sim_fail(call, n, SM_E_DENIED);
        CHECK(init(io) == SM_E_DENIED);
        CHECK(io->failed < io->pins);
        CHECK(init(io) == SM_OK);
    }
}

static void test_missing_pin(void)
{
    SmIoPin row[] = {{SM_ANALOG_IN, SM_F64, 0, 0, 1, 0, 0, 0, 0}, {SM_ANALOG_IN, SM_F64, 0, 0, 99, 0, 0, 0, 0}};
    uint8_t handle[2];
    uint16_t missed[2];
    uint64_t value[2];
    SmIo io = {row, 2, sv, handle, missed, value, 7};

    renew(true);
    row[0].scale = row[1].scale = sm_bits(sm_from_i32(1));
    CHECK(sm_inputs_init(&io) == SM_E_MISSING && io.failed == 1);
    CHECK(sm_inputs_init(&io) == SM_E_MISSING && io.failed == 1);         // the pin that was opened first has been closed
    io.pins = 1;
    CHECK(sm_inputs_init(&io) == SM_OK);
    sm_inputs_close(&io);
    CHECK(sm_inputs_init(&io) == SM_OK);
}

static SmResult init_of(SmIoPin row)
{
    uint8_t handle;
    uint16_t missed;
    uint64_t value;
    SmIo io = {&row, 1, sv, &handle, &missed, &value, 0};
    SmResult r;

    renew(true);
    r = sm_inputs_init(&io);
    return r == SM_OK ? sm_outputs_init(&io) : r;
}

// Rows that the compiler never emits.
static void test_senseless(void)
{
    const uint64_t one = 0x3FF0000000000000u, nan = 0x7FF8000000000000u, infinite = 0x7FF0000000000000u;
    const uint32_t last = sv->layout->whole.size;
    const SmIoPin good = {SM_ANALOG_IN, SM_F64, 0, 0, 1, 0, one, 0, 0};
    SmIoPin row;

    CHECK(init_of(good) == SM_OK);
#define REFUSED(change) (row = good, change, init_of(row) == SM_E_ARGUMENT)
    CHECK(REFUSED(row.kind = 4));
    CHECK(REFUSED(row.kind = 255));
    CHECK(REFUSED(row.type = SM_TYPE_COUNT));
    CHECK(REFUSED(row.type = SM_BOOL));
    CHECK(REFUSED(row.kind = SM_DIGITAL_IN));
    CHECK(REFUSED(row.offset = last - 7));
    CHECK(REFUSED(row.offset = last));
    CHECK(REFUSED(row.offset = UINT32_MAX));
    CHECK(REFUSED(row.scale = 0));
    CHECK(REFUSED(row.scale = 0x8000000000000000u));
    CHECK(REFUSED(row.scale = nan));
    CHECK(REFUSED(row.zero = infinite));
    CHECK(REFUSED((row.kind = SM_ANALOG_OUT, row.safe = nan)));
    row = good;
    row.offset = last - 8;
    CHECK(init_of(row) == SM_OK);
    CHECK(sm_inputs_init(NULL) == SM_E_ARGUMENT && sm_outputs_init(NULL) == SM_E_ARGUMENT);
}

// One table may have both directions.  Each task uses only the rows of its own direction.
static void test_both_directions(void)
{
    static const SmIoPin row[] = {
        {SM_ANALOG_IN, SM_F64, 0, 0, 1, 0, 0x3FF0000000000000u, 0, 0}, {SM_DIGITAL_OUT, SM_BOOL, 0, 0, 5, 24, 0, 0, 0x3FF0000000000000u}};
    uint8_t handle[2];
    uint16_t missed[2];
    uint64_t value[2];
    SmIo io = {row, 2, sv, handle, missed, value, 0};

    renew(true);
    CHECK(sm_inputs_init(&io) == SM_OK && !sim_pin(5));
    CHECK(sm_outputs_init(&io) == SM_OK && sim_pin(5));
    CHECK(sm_inputs_step(&io, &tick) == SM_OK && sim_count(SIM_dio_write) == 0);
    CHECK(sm_outputs_step(&io, &tick) == SM_OK && !sim_pin(5) && sim_count(SIM_aio_read) == 1);
    sm_inputs_close(&io);
    CHECK(sm_outputs_safe(&io, &tick) == SM_OK && sim_pin(5));
}

static void test_no_pins(void)
{
    SmIo io = {NULL, 0, sv, NULL, NULL, NULL, 0};

    renew(true);
    CHECK(sm_inputs_init(&io) == SM_OK && sm_outputs_init(&io) == SM_OK);
    CHECK(sm_inputs_step(&io, &tick) == SM_OK && sm_outputs_step(&io, &tick) == SM_OK && sm_outputs_safe(&io, &tick) == SM_OK);
}

// ---- a table that an image carries ----

static bool same_row(const SmIoPin *a, const SmIoPin *b)
{
    bool numbers = a->kind & 2 ? a->safe == b->safe : a->scale == b->scale && a->zero == b->zero && a->safe == b->safe;

    return a->kind == b->kind && a->type == b->type && a->flags == b->flags && a->hold == b->hold && a->pin == b->pin &&
           a->offset == b->offset && numbers;
}

// The rows are those of the .io as C, with inputs and outputs in one table, and have the same effect.
static void test_image(void)
{
    SmIoPin row[14];
    uint8_t handle[14];
    uint16_t missed[14], i = 0, o = 0;
    uint64_t value[14];
    SmIo io = {row, 0, sv, handle, missed, value, 0};
    SmvmVerdict v;

    renew(true);
    CHECK(smvm_verify(pins_image, sizeof pins_image, &v) == 0);
    CHECK(smvm_target_pins(pins_image, sv, row, 13, &io.pins) == SM_E_MEMORY && io.pins == 0);
    CHECK(smvm_target_pins(pins_image, sv, row, 14, &io.pins) == SM_OK && io.pins == in->pins + out->pins);
    for (uint16_t k = 0; k < io.pins; k++)
        CHECK(same_row(&row[k], row[k].kind & 1 ? &out->pin[o++] : &in->pin[i++]));
    CHECK(sm_inputs_init(&io) == SM_OK && sm_outputs_init(&io) == SM_OK && is_safe());
    sim_set_analog(0, 1000000);
    CHECK(sm_inputs_step(&io, &tick) == SM_OK && pins_sv.pressure == 125.0);
}

static void test_image_of_others(void)
{
    SmLayout other = *sv->layout;
    SmStateVec strange = *sv;
    SmIoPin row[14];
    uint16_t n = 1;

    strange.layout = &other;
    other.hash++;
    CHECK(smvm_target_pins(pins_image, &strange, row, 14, &n) == SM_E_LAYOUT && n == 0);
    other = *sv->layout;
    other.whole.size += 8;
    CHECK(smvm_target_pins(pins_image, &strange, row, 14, &n) == SM_E_LAYOUT);
    CHECK(smvm_target_pins(second_image, sv, row, 14, &n) == SM_OK && n == 0);           // an image without pins
}

// ---- the critical section ----

static unsigned met, locked;

static void check_lock(void)
{
    met++;
    if (pal_lock_take(sv->lock, 0) == SM_OK)
        pal_lock_give(sv->lock);
    else
        locked++;
}

// Pins take time, during which other tasks access the vector.  All elements are still stored at once.
static void test_lock(void)
{
    start(true);
    CHECK((step_in(), sim_count(SIM_lock_take)) == 1);
    CHECK((step_out(), sim_count(SIM_lock_take)) == 2);
    CHECK((sm_outputs_safe(out, &tick), sim_count(SIM_lock_take)) == 2);
    sim_delay(SIM_aio_read, 1000);
    sim_delay(SIM_aio_write, 1000);
    sim_delay(SIM_dio_read, 1000);
    sim_delay(SIM_dio_write, 1000);
    sim_every(500, check_lock);
    met = locked = 0;
    CHECK(step_in() == SM_OK && step_out() == SM_OK);
    CHECK(met > 20 && locked == 0);
    sim_every(0, NULL);
}

static void test_no_lock(void)
{
    start(true);
    sim_set_analog(0, 2000000);
    CHECK(step_in() == SM_OK && step_out() == SM_OK);
    sim_set_analog(0, 3000000);
    pins_sv.heater = 6;
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(step_in() == SM_E_TIMEOUT && pins_sv.pressure == 375.0);
    CHECK(step_out() == SM_E_TIMEOUT && sim_analog(7) == 0);
    CHECK(sm_outputs_safe(out, &tick) == SM_OK && is_safe());             // this needs no vector
    sim_break(SIM_lock_take, 0, SM_OK);
    CHECK(step_in() == SM_OK && pins_sv.pressure == 625.0);
}

int main(void)
{
    for (int guarded = 0; guarded < 2; guarded++) {
        test_inputs(guarded);
        test_outputs(guarded);
    }
    test_pulls();
    test_input_arithmetic();
    test_output_arithmetic();
    test_outputs_each_step();
    test_safe();
    test_safe_failing();
    test_hold();
    test_long_hold();
    test_digital_failing();
    test_one_failing();
    test_refused(SIM_aio_open, in, sm_inputs_init);
    test_refused(SIM_dio_open, in, sm_inputs_init);
    test_refused(SIM_aio_open, out, sm_outputs_init);
    test_refused(SIM_aio_write, out, sm_outputs_init);
    test_refused(SIM_dio_open, out, sm_outputs_init);
    test_missing_pin();
    test_senseless();
    test_both_directions();
    test_no_pins();
    test_image();
    test_image_of_others();
    test_lock();
    test_no_lock();
    return test_end("runtime-io");
}
