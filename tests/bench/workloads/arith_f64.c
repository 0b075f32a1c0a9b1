// SPDX-License-Identifier: Apache-2.0
// The arithmetic by the definitions of the language: every value a double, every store a conversion.
#include <math.h>
#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"
#include "tests/bench/workloads/arith.h"

void arith_f64_init(ArithF64 *m, ArithSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = 1;
    m->first = true;
    sv->state = 1;
}

// Reads values as the language does from variables of types F32 and F64.
#define F(x) sm_read_f32(x)
#define D(x) sm_read_f64(x)
#define I(x) ((double)(x))

static void units(ArithSv *sv)
{
    sv->volts0 = sm_to_f32(I(sv->adc0) * 5.0 / 4096.0);
    sv->volts1 = sm_to_f32(I(sv->adc1) * 5.0 / 4096.0);
    sv->current = sm_to_f32((F(sv->volts0) - 2.5) / 0.066);
    sv->power = sm_to_f32(F(sv->current) * F(sv->volts1));
    sv->energy = sm_to_f64(D(sv->energy) + F(sv->power) * 0.02);
    sv->celsius = sm_to_f32(I(sv->adc2) * 3.3 / 4096.0 * 100.0 - 50.0);
    sv->kelvin = sm_to_f64(F(sv->celsius) + 273.15);
    sv->rateX = sm_to_f32(I(sv->gyroX) * 0.00106);
    sv->rateY = sm_to_f32(I(sv->gyroY) * 0.00106);
    sv->rateZ = sm_to_f32(I(sv->gyroZ) * 0.00106);
    sv->altitude = sm_to_f64((101.325 - D(sv->pressure)) * 84.3);
    sv->density = sm_to_f64(D(sv->pressure) / (D(sv->kelvin) * 0.287));
    sv->lift = sm_to_f32(D(sv->density) * F(sv->airspeed) * F(sv->airspeed) / 2.0);
}

static void whole(ArithSv *sv)
{
    sv->turn = sm_to_i16(I(sv->gyroX) + I(sv->gyroY) + I(sv->gyroZ));
    sv->mean = sm_to_i16((I(sv->gyroX) + I(sv->gyroY) + I(sv->gyroZ)) / 3.0);
    sv->trimmed = sm_to_i16(I(sv->gyroX) - I(sv->trim));
    sv->half = sm_to_i8(I(sv->gyroZ) / 256.0);
    sv->tilt = sm_to_i8(I(sv->gyroY) / 64.0 + I(sv->trim));
    sv->spin = sm_to_u32(I(sv->gyroX) * I(sv->gyroX) + I(sv->gyroY) * I(sv->gyroY));
    sv->product = sm_to_i32(I(sv->gyroX) * I(sv->adc1));
    sv->miss = sm_to_i32(I(sv->setpoint) - I(sv->encoder));
    sv->level = sm_to_u8(I(sv->adc2) / 16.0);
}

static void counters(ArithF64 *m, ArithSv *sv)
{
    sv->ticks = sm_to_u64(I(sv->ticks) + 1.0);
    sv->beats = sm_to_u8(I(sv->beats) + I(sv->mode));
    sv->total = sm_to_u32(I(sv->total) + I(sv->adc0) + I(sv->adc1));
    sv->balance = sm_to_i64(I(sv->balance) + I(sv->adc0) - I(sv->adc1));
    sv->position = sm_to_i64(I(sv->position) + I(sv->encoder));
    sv->pulses = sm_to_u64(I(sv->pulses) + fabs(I(sv->encoder) - I(m->before)));
    m->before = sm_to_i32(I(sv->encoder));
    sv->minutes = sm_to_u32(I(sv->ticks) / 3000.0);
    sv->rest = sm_to_u32(I(sv->ticks) - I(sv->minutes) * 3000.0);
}

static void filters(ArithF64 *m, ArithSv *sv)
{
    sv->smooth = sm_to_f32(F(sv->smooth) + (I(sv->adc0) - F(sv->smooth)) / 8.0);
    sv->slow = sm_to_u16((I(sv->slow) * 7.0 + I(sv->adc1)) / 8.0);
    m->drift = sm_to_f32(F(m->drift) * 0.99 + F(sv->rateZ) * 0.01);
    if (I(sv->adc2) > I(sv->high))
        sv->high = sm_to_u16(I(sv->adc2));
    if (I(sv->low) == 0.0 || I(sv->adc2) < I(sv->low))
        sv->low = sm_to_u16(I(sv->adc2));
    sv->high = sm_to_u16(I(sv->high) - 1.0);
    m->last = sm_to_u16(sm_max(I(sv->adc0), I(sv->adc1)) - sm_min(I(sv->adc0), I(sv->adc1)));
}

static void control(ArithF64 *m, ArithSv *sv)
{
    if (sv->enable)
        sv->integral = sm_to_f64(sm_min(sm_max(D(sv->integral) + I(sv->miss) * 0.01, -500.0), 500.0));
    else
        sv->integral = 0.0;
    sv->command = sm_to_f64(I(sv->miss) * 0.5 + D(sv->integral) - F(m->drift));
    sv->pwm = sm_to_u8(D(sv->command) / 8.0 + 128.0);
    sv->duty = sm_to_u8(I(sv->pwm) * 100.0 / 255.0);
    sv->direction = sm_to_i8(I(D(sv->command) > 0.0) - I(D(sv->command) < 0.0));
    sv->brake = fabs(D(sv->command)) < 20.0 && !sv->enable;
}

static void judge(ArithF64 *m, ArithSv *sv)
{
    sv->hot = F(sv->celsius) > 120.0 || F(sv->volts1) > 4.5;
    sv->spinning = I(sv->spin) > 500000000.0;
    sv->steady = fabs(F(sv->rateX)) < 5.0 && fabs(F(sv->rateY)) < 5.0 && fabs(F(sv->rateZ)) < 5.0;
    if (I(sv->adc0) == 0.0 || I(sv->adc0) == 4095.0)
        m->bad = sm_to_u16(I(m->bad) + 1.0);
    if (I(m->bad) > 3.0) {
        sv->errors = sm_to_u16(I(sv->errors) + 1.0);
        m->bad = 0;
    }
    sv->alarm = I(sv->errors) > 100.0 || (sv->hot && sv->spinning);
    if (I(sv->mode) == 3.0 && sv->alarm)
        sv->errors = sm_to_u16(I(sv->errors) - 100.0);
    if (I(m->last) > 3000.0 && I(sv->mode) != 2.0)
        sv->tilt = sm_to_i8(-I(sv->tilt));
}

void arith_f64_step(ArithF64 *m, ArithSv *sv)
{
    if (sv->time == UINT64_MAX || (m->ran && sv->time <= m->before_g))
        return;
    m->ran = true;
    m->before_g = sv->time;
    if (m->first) {
        m->start = sv->time;
        sv->state = m->state;
    }
    m->T = sv->time - m->start;
    m->first = false;
    units(sv);
    whole(sv);
    counters(m, sv);
    filters(m, sv);
    control(m, sv);
    judge(m, sv);
}
