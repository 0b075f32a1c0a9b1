// SPDX-License-Identifier: Apache-2.0
// The glider by the definitions of the language: every value a double, every store a conversion, every function that of the language.
#include <math.h>
#include <string.h>

#include "stdlib/elementary.h"
#include "tests/bench/workloads/guide.h"

enum { HOME = 1, CIRCLE, FLARE };

static const double dt = 0.02, earth = 6371000, pi = 3.141592653589793;

void guide_f64_init(GuideF64 *m, GuideSv *sv)
{
    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    sv->state = HOME;
}

static void attitude(GuideF64 *m, GuideSv *sv)
{
    m->sr = sm_to_f64(sm_sin(D(sv->roll)));
    m->cr = sm_to_f64(sm_cos(D(sv->roll)));
    m->h = sm_to_f64(F(sv->gyroQ) * D(m->sr) + F(sv->gyroR) * D(m->cr));
    sv->roll = sm_to_f64(0.99 * (D(sv->roll) + dt * (F(sv->gyroP) + D(m->h) * sm_tan(D(sv->pitch)))));
    sv->yaw = sm_to_f64(D(sv->yaw) + dt * D(m->h) / sm_cos(D(sv->pitch)));
    sv->pitch = sm_to_f64(0.99 * (D(sv->pitch) + dt * (F(sv->gyroQ) * D(m->cr) - F(sv->gyroR) * D(m->sr))));
    sv->yaw = sm_to_f64(D(sv->yaw) - 2.0 * pi * floor((D(sv->yaw) + pi) / (2.0 * pi)));
}

static void position(GuideF64 *m, GuideSv *sv)
{
    m->north = sm_to_f64(F(sv->airspeed) * sm_cos(D(sv->pitch)) * sm_cos(D(sv->yaw)) + F(sv->windNorth));
    m->east = sm_to_f64(F(sv->airspeed) * sm_cos(D(sv->pitch)) * sm_sin(D(sv->yaw)) + F(sv->windEast));
    sv->track = sm_to_f64(sm_atan2(D(m->east), D(m->north)));
    sv->lat = sm_to_f64(D(sv->lat) + dt * D(m->north) / earth);
    sv->lon = sm_to_f64(D(sv->lon) + dt * D(m->east) / (earth * sm_cos(D(sv->lat))));
}

static void way(GuideF64 *m, GuideSv *sv)
{
    const double lat = F(sv->padLat), lon = F(sv->padLon);

    m->h = sm_to_f64(sm_sin((lat - D(sv->lat)) / 2.0) * sm_sin((lat - D(sv->lat)) / 2.0) +
                     sm_cos(D(sv->lat)) * sm_cos(lat) * sm_sin((lon - D(sv->lon)) / 2.0) * sm_sin((lon - D(sv->lon)) / 2.0));
    sv->distance = sm_to_f64(2.0 * earth * sm_asin(sm_min(sqrt(D(m->h)), 1.0)));
    sv->bearing = sm_to_f64(sm_atan2(sm_sin(lon - D(sv->lon)) * sm_cos(lat),
                                     sm_cos(D(sv->lat)) * sm_sin(lat) - sm_sin(D(sv->lat)) * sm_cos(lat) * sm_cos(lon - D(sv->lon))));
    m->error = sm_to_f64(D(sv->bearing) - D(sv->track));
    m->error = sm_to_f64(D(m->error) - 2.0 * pi * floor((D(m->error) + pi) / (2.0 * pi)));
    sv->density = sm_to_f32(1.225 * sm_exp(-D(sv->distance) / 8400.0));
}

static void enter(const GuideF64 *m, GuideSv *sv)
{
    if (m->frame.state == CIRCLE)
        sv->rounds = sm_to_u16(I(sv->rounds) + 1.0);
    else
        sv->flare = m->frame.state == FLARE;
}

static uint32_t home_step(const GuideF64 *m, GuideSv *sv)
{
    sv->bank = sm_to_f32(sm_clamp(sm_atan2(sm_hypot(D(m->north), D(m->east)) * D(m->error) * 0.3, 9.81), -0.8, 0.8));
    sv->rudder = sm_to_i16(D(m->error) * 2000.0);
    return D(sv->distance) < 400.0 ? CIRCLE : 0;
}

static uint32_t circle_step(const GuideF64 *m, GuideSv *sv)
{
    sv->bank = sm_to_f32(sm_atan(F(sv->airspeed) * F(sv->airspeed) / (9.81 * sm_max(D(sv->distance), 50.0))));
    sv->rudder = sm_to_i16(3000.0 * sm_sin(D(m->error)) - 500.0 * sm_sin(2.0 * D(m->error)));
    if (D(sv->distance) > 600.0)
        return HOME;
    return I(m->frame.T) > 4000.0 && fabs(D(m->error)) < 0.3 ? FLARE : 0;
}

static uint32_t flare_step(const GuideF64 *m, GuideSv *sv)
{
    sv->bank = sm_to_f32(0.1 * sm_log(1.0 + D(sv->distance)) * sm_sign(D(m->error)));
    sv->rudder = 0;
    return I(m->frame.T) > 2000.0 ? HOME : 0;
}

void guide_f64_step(GuideF64 *m, GuideSv *sv)
{
    uint32_t to;

    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    if (m->frame.first)
        enter(m, sv);
    attitude(m, sv);
    position(m, sv);
    way(m, sv);
    to = m->frame.state == HOME ? home_step(m, sv) : m->frame.state == CIRCLE ? circle_step(m, sv) : flare_step(m, sv);
    frame_end(&m->frame, to);
}
