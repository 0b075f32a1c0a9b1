// SPDX-License-Identifier: Apache-2.0
// The filters as a flight-software engineer writes them: in float.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/f32filter.h"

static inline float limit(float x, float least, float most)
{
    x = x < least ? least : x;
    return x > most ? most : x;
}

void f32filter_native_init(F32filterNative *m, F32filterSv *sv)
{
    memset(m, 0, sizeof *m);
    m->first = true;
    sv->state = 1;
}

void f32filter_native_step(F32filterNative *m, F32filterSv *sv)
{
    const float accX = sv->accX, accY = sv->accY, accZ = sv->accZ, gyroX = sv->gyroX, baro = sv->baro;
    const float smoothX = sv->smoothX + (accX - sv->smoothX) * 0.125f;
    const float smoothY = sv->smoothY + (accY - sv->smoothY) * 0.125f;
    const float smoothZ = sv->smoothZ + (accZ - sv->smoothZ) * 0.125f;
    const float notchX = 0.90f * (accX + m->xb) - 1.55f * (m->xa - m->ya) - 0.80f * m->yb;
    const float notchY = 0.85f * (accY + m->ub) - 1.20f * (m->ua - m->va) - 0.70f * m->vb;
    const float pitch = 0.98f * (sv->pitch + gyroX * 0.01f) + 0.02f * smoothX;
    const float error = baro - sv->height;
    const float climb = limit((sv->climb + (smoothZ * 0.01f + error * 0.02f)) * 0.999f, -300, 300);
    const float slewed = sv->slewed + limit(sv->command - sv->slewed, -0.5f, 0.5f);
    const float band = 0.9f * (sv->band + baro - m->lastBand);
    const float integral = limit(sv->integral + (slewed - pitch) * 0.01f, -2, 2);
    const float output = limit((slewed - pitch) * 1.5f + integral - gyroX * 0.2f, -1, 1);
    const float energy = sv->energy * 0.99f + (accX * accX + accY * accY + accZ * accZ) * 0.01f;
    const float peak = sv->peak * 0.995f, size = fabsf(notchX) + fabsf(notchY);

    if (m->first) {
        m->first = false;
        sv->state = 1;
    }
    sv->smoothX = smoothX;
    sv->smoothY = smoothY;
    sv->smoothZ = smoothZ;
    sv->notchX = notchX;
    m->xb = m->xa;
    m->xa = accX;
    m->yb = m->ya;
    m->ya = notchX;
    sv->notchY = notchY;
    m->ub = m->ua;
    m->ua = accY;
    m->vb = m->va;
    m->va = notchY;
    sv->pitch = pitch;
    sv->roll = 0.98f * (sv->roll + sv->gyroY * 0.01f) + 0.02f * smoothY;
    sv->error = error;
    sv->climb = climb;
    sv->height += climb * 0.01f + error * 0.1f;
    sv->slewed = slewed;
    sv->washed = 0.95f * (sv->washed + smoothX - m->lastWash);
    m->lastWash = smoothX;
    sv->band = band;
    m->lastBand = baro;
    m->slowBand += (fabsf(band) - m->slowBand) * 0.01f;
    sv->lead = smoothY + (smoothY - m->lastLead) * 4;
    m->lastLead = smoothY;
    sv->integral = integral;
    sv->output = output;
    sv->energy = energy;
    sv->peak = size > peak ? size : peak;
    sv->moving = (energy > 30) | (m->slowBand > 2);
    sv->saturated = (output == 1) | (output == -1);
}
