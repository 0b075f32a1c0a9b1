// SPDX-License-Identifier: Apache-2.0
// The filters by the definitions of the language: every value a double, every store a conversion.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/f32filter.h"

static inline double clamp(double x, double least, double most) { return sm_min(sm_max(x, least), most); }

void f32filter_f64_init(F32filterF64 *m, F32filterSv *sv)
{
    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    sv->state = 1;
}

static void step(F32filterF64 *m, F32filterSv *sv)
{
    sv->smoothX = sm_to_f32(F(sv->smoothX) + (F(sv->accX) - F(sv->smoothX)) * 0.125);
    sv->smoothY = sm_to_f32(F(sv->smoothY) + (F(sv->accY) - F(sv->smoothY)) * 0.125);
    sv->smoothZ = sm_to_f32(F(sv->smoothZ) + (F(sv->accZ) - F(sv->smoothZ)) * 0.125);
    sv->notchX = sm_to_f32(0.90 * F(sv->accX) - 1.55 * F(m->xa) + 0.90 * F(m->xb) + 1.55 * F(m->ya) - 0.80 * F(m->yb));
    m->xb = sm_to_f32(F(m->xa));
    m->xa = sm_to_f32(F(sv->accX));
    m->yb = sm_to_f32(F(m->ya));
    m->ya = sm_to_f32(F(sv->notchX));
    sv->notchY = sm_to_f32(0.85 * F(sv->accY) - 1.20 * F(m->ua) + 0.85 * F(m->ub) + 1.20 * F(m->va) - 0.70 * F(m->vb));
    m->ub = sm_to_f32(F(m->ua));
    m->ua = sm_to_f32(F(sv->accY));
    m->vb = sm_to_f32(F(m->va));
    m->va = sm_to_f32(F(sv->notchY));
    sv->pitch = sm_to_f32(0.98 * (F(sv->pitch) + F(sv->gyroX) * 0.01) + 0.02 * F(sv->smoothX));
    sv->roll = sm_to_f32(0.98 * (F(sv->roll) + F(sv->gyroY) * 0.01) + 0.02 * F(sv->smoothY));
    sv->error = sm_to_f32(F(sv->baro) - F(sv->height));
    sv->climb = sm_to_f32(F(sv->climb) + (F(sv->smoothZ) * 0.01 + F(sv->error) * 0.02));
    sv->climb = sm_to_f32(clamp(F(sv->climb) * 0.999, -300.0, 300.0));
    sv->height = sm_to_f32(F(sv->height) + F(sv->climb) * 0.01 + F(sv->error) * 0.1);
    sv->slewed = sm_to_f32(F(sv->slewed) + clamp(F(sv->command) - F(sv->slewed), -0.5, 0.5));
    sv->washed = sm_to_f32(0.95 * (F(sv->washed) + F(sv->smoothX) - F(m->lastWash)));
    m->lastWash = sm_to_f32(F(sv->smoothX));
    sv->band = sm_to_f32(0.9 * (F(sv->band) + F(sv->baro) - F(m->lastBand)));
    m->lastBand = sm_to_f32(F(sv->baro));
    m->slowBand = sm_to_f32(F(m->slowBand) + (fabs(F(sv->band)) - F(m->slowBand)) * 0.01);
    sv->lead = sm_to_f32(F(sv->smoothY) + (F(sv->smoothY) - F(m->lastLead)) * 4.0);
    m->lastLead = sm_to_f32(F(sv->smoothY));
    sv->integral = sm_to_f32(clamp(F(sv->integral) + (F(sv->slewed) - F(sv->pitch)) * 0.01, -2.0, 2.0));
    sv->output = sm_to_f32(clamp((F(sv->slewed) - F(sv->pitch)) * 1.5 + F(sv->integral) - F(sv->gyroX) * 0.2, -1.0, 1.0));
    sv->energy = sm_to_f32(F(sv->energy) * 0.99 + (F(sv->accX) * F(sv->accX) + F(sv->accY) * F(sv->accY) + F(sv->accZ) * F(sv->accZ)) * 0.01);
    sv->peak = sm_to_f32(sm_max(F(sv->peak) * 0.995, fabs(F(sv->notchX)) + fabs(F(sv->notchY))));
    sv->moving = F(sv->energy) > 30.0 || F(m->slowBand) > 2.0;
    sv->saturated = F(sv->output) == 1.0 || F(sv->output) == -1.0;
}

void f32filter_f64_step(F32filterF64 *m, F32filterSv *sv)
{
    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    step(m, sv);
    frame_end(&m->frame, 0);
}
