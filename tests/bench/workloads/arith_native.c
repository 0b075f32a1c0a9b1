// SPDX-License-Identifier: Apache-2.0
// The arithmetic as a flight-software engineer writes it: float where the result is a float, integers where the operands are integers, constants
// combined by hand, and limits only where a value can reach them.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bench/workloads/arith.h"

static int16_t sat_i16(int32_t x) { return (int16_t)(x < INT16_MIN ? INT16_MIN : x > INT16_MAX ? INT16_MAX : x); }
static int8_t sat_i8(int32_t x) { return (int8_t)(x < INT8_MIN ? INT8_MIN : x > INT8_MAX ? INT8_MAX : x); }
static uint8_t sat_u8(int32_t x) { return (uint8_t)(x < 0 ? 0 : x > UINT8_MAX ? UINT8_MAX : x); }

void arith_native_init(ArithNative *m, ArithSv *sv)
{
    memset(m, 0, sizeof *m);
    m->first = true;
    sv->state = 1;
}

static void units(ArithSv *sv)
{
    sv->volts0 = (float)sv->adc0 * (5.0f / 4096.0f);
    sv->volts1 = (float)sv->adc1 * (5.0f / 4096.0f);
    sv->current = (sv->volts0 - 2.5f) / 0.066f;
    sv->power = sv->current * sv->volts1;
    sv->energy += (double)sv->power * 0.02;
    sv->celsius = (float)sv->adc2 * (330.0f / 4096.0f) - 50.0f;
    sv->kelvin = (double)sv->celsius + 273.15;
    sv->rateX = (float)sv->gyroX * 0.00106f;
    sv->rateY = (float)sv->gyroY * 0.00106f;
    sv->rateZ = (float)sv->gyroZ * 0.00106f;
    sv->altitude = (101.325 - sv->pressure) * 84.3;
    sv->density = sv->pressure / (sv->kelvin * 0.287);
    sv->lift = (float)sv->density * sv->airspeed * sv->airspeed * 0.5f;
}

static void whole(ArithSv *sv)
{
    const int32_t sum = sv->gyroX + sv->gyroY + sv->gyroZ;

    sv->turn = sat_i16(sum);
    sv->mean = (int16_t)(sum / 3);
    sv->trimmed = sat_i16(sv->gyroX - sv->trim);
    sv->half = (int8_t)(sv->gyroZ / 256);
    sv->tilt = sat_i8((sv->gyroY + sv->trim * 64) / 64);
    sv->spin = (uint32_t)(sv->gyroX * sv->gyroX) + (uint32_t)(sv->gyroY * sv->gyroY);
    sv->product = sv->gyroX * sv->adc1;
    sv->miss = sv->setpoint - sv->encoder;
    sv->level = (uint8_t)(sv->adc2 / 16);
}

static void counters(ArithNative *m, ArithSv *sv)
{
    sv->ticks++;
    sv->beats = sat_u8(sv->beats + sv->mode);
    sv->total += (uint32_t)sv->adc0 + sv->adc1;
    sv->balance += sv->adc0 - sv->adc1;
    sv->position += sv->encoder;
    sv->pulses += (uint64_t)abs(sv->encoder - m->before);
    m->before = sv->encoder;
    sv->minutes = (uint32_t)(sv->ticks / 3000);
    sv->rest = (uint32_t)(sv->ticks % 3000);
}

static void filters(ArithNative *m, ArithSv *sv)
{
    sv->smooth += ((float)sv->adc0 - sv->smooth) * 0.125f;
    sv->slow = (uint16_t)((sv->slow * 7u + sv->adc1) / 8u);
    m->drift = m->drift * 0.99f + sv->rateZ * 0.01f;
    if (sv->adc2 > sv->high)
        sv->high = sv->adc2;
    if (sv->low == 0 || sv->adc2 < sv->low)
        sv->low = sv->adc2;
    if (sv->high > 0)
        sv->high--;
    m->last = (uint16_t)abs(sv->adc0 - sv->adc1);
}

static void control(ArithNative *m, ArithSv *sv)
{
    if (sv->enable) {
        const double integral = sv->integral + sv->miss * 0.01;
        sv->integral = integral < -500 ? -500 : integral > 500 ? 500 : integral;
    } else {
        sv->integral = 0;
    }
    sv->command = sv->miss * 0.5 + sv->integral - (double)m->drift;
    sv->pwm = sat_u8((int32_t)(sv->command * 0.125 + 128));
    sv->duty = (uint8_t)(sv->pwm * 100 / 255);
    sv->direction = (int8_t)((sv->command > 0) - (sv->command < 0));
    sv->brake = fabs(sv->command) < 20 && !sv->enable;
}

static void judge(ArithNative *m, ArithSv *sv)
{
    sv->hot = sv->celsius > 120.0f || sv->volts1 > 4.5f;
    sv->spinning = sv->spin > 500000000;
    sv->steady = fabsf(sv->rateX) < 5.0f && fabsf(sv->rateY) < 5.0f && fabsf(sv->rateZ) < 5.0f;
    if (sv->adc0 == 0 || sv->adc0 == 4095)
        m->bad++;
    if (m->bad > 3) {
        if (sv->errors < UINT16_MAX)
            sv->errors++;
        m->bad = 0;
    }
    sv->alarm = sv->errors > 100 || (sv->hot && sv->spinning);
    if (sv->mode == 3 && sv->alarm)
        sv->errors = sv->errors > 100 ? (uint16_t)(sv->errors - 100) : 0;
    if (m->last > 3000 && sv->mode != 2)
        sv->tilt = sat_i8(-sv->tilt);
}

void arith_native_step(ArithNative *m, ArithSv *sv)
{
    if (m->first) {
        m->first = false;
        sv->state = 1;
    }
    units(sv);
    whole(sv);
    counters(m, sv);
    filters(m, sv);
    control(m, sv);
    judge(m, sv);
}
