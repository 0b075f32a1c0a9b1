// SPDX-License-Identifier: Apache-2.0
// The counters by the definitions of the language: every value a double, every store a conversion.
#include <math.h>

#include "tests/bench/workloads/intcount.h"

void intcount_f64_init(IntcountF64 *m, IntcountSv *sv)
{
    frame_init(&m->frame);
    m->tenths = 0;
    m->last = 0;
    m->before = 0;
    sv->state = 1;
}

static void sums(IntcountF64 *m, IntcountSv *sv)
{
    sv->ticks = sm_to_u32(I(sv->ticks) + 1.0);
    if (sv->pulse)
        sv->pulses = sm_to_u32(I(sv->pulses) + 1.0);
    sv->travel = sm_to_u32(I(sv->travel) + fabs(I(sv->encoder) - I(m->before)));
    sv->position = sm_to_i32(I(sv->position) + I(sv->encoder) - I(m->before));
    sv->rate = sm_to_i16(I(sv->encoder) - I(m->before));
    m->before = sm_to_i32(I(sv->encoder));
    sv->energy = sm_to_u32(I(sv->energy) + I(sv->adc0) * I(sv->mode));
    sv->balance = sm_to_i32(I(sv->balance) + I(sv->adc0) - I(sv->adc1));
    sv->error = sm_to_i32(I(sv->encoder) - 1000.0 * I(sv->mode));
    sv->faults = sm_to_u16(I(sv->faults) + I(sv->fault != 0));
    sv->high = sm_to_u16(sm_max(I(sv->adc0), I(sv->high) - 3.0));
    if (I(sv->adc0) > 100.0)
        sv->quiet = 0;
    else
        sv->quiet = sm_to_u16(I(sv->quiet) + 1.0);
    sv->span = sm_to_u16(sm_max(I(sv->adc0), I(m->last)) - sm_min(I(sv->adc0), I(m->last)));
    m->last = sm_to_u16(I(sv->adc0));
    sv->turn = sm_to_i16(I(sv->turn) + I(sv->gyro));
    sv->drift = sm_to_i16(I(sv->drift) - I(sv->gyro) / 16.0 + I(sv->trim));
}

static void levels(IntcountF64 *m, IntcountSv *sv)
{
    if (sv->pulse)
        sv->debounce = sm_to_u8(I(sv->debounce) + 16.0);
    else
        sv->debounce = sm_to_u8(I(sv->debounce) - 9.0);
    sv->leak = sm_to_u8(I(sv->leak) + 40.0 * I(sv->fault != 0) - 1.0);
    if (I(sv->mode) == 3.0)
        sv->retries = sm_to_u8(I(sv->retries) + 1.0);
    else if (I(sv->mode) == 0.0)
        sv->retries = 0;
    m->tenths = sm_to_u8(I(m->tenths) + 1.0);
    if (I(m->tenths) >= 10.0) {
        m->tenths = 0;
        sv->seconds = sm_to_u8(I(sv->seconds) + 1.0);
        if (I(sv->seconds) >= 60.0) {
            sv->seconds = 0;
            sv->minutes = sm_to_u8(I(sv->minutes) + 1.0);
        }
    }
    if (sv->fault)
        sv->score = sm_to_i8(I(sv->score) - 20.0);
    else
        sv->score = sm_to_i8(I(sv->score) + 1.0);
    sv->tilt = sm_to_i8(I(sv->trim) * 3.0 + I(sv->mode));
    sv->bias = sm_to_i8(I(sv->bias) + I(I(sv->adc0) > I(sv->adc1)) - I(I(sv->adc0) < I(sv->adc1)));
    sv->alarm = I(sv->leak) > 100.0 || I(sv->score) < -100.0 || I(sv->faults) > 1000.0;
    sv->steady = I(sv->debounce) == 255.0 && I(sv->span) < 50.0;
    sv->late = I(sv->travel) - I(sv->pulses) * 4.0 > 100000.0 || I(sv->quiet) > 500.0;
}

void intcount_f64_step(IntcountF64 *m, IntcountSv *sv)
{
    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    sums(m, sv);
    levels(m, sv);
    frame_end(&m->frame, 0);
}
