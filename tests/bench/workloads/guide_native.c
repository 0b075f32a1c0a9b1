// SPDX-License-Identifier: Apache-2.0
// The glider as an expert writes it: each sine and cosine once, the functions of the C library, and double angles by identities.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/guide.h"

enum { HOME = 1, CIRCLE, FLARE };

#define PI 3.141592653589793
#define EARTH 6371000.0
#define DT 0.02

void guide_native_init(GuideNative *m, GuideSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = HOME;
    m->first = true;
    sv->state = HOME;
}

static inline double wrapped(double angle) { return angle - 2 * PI * floor((angle + PI) * (1 / (2 * PI))); }

static inline void attitude(GuideSv *sv)
{
    const double sr = sin(sv->roll), cr = cos(sv->roll), sp = sin(sv->pitch), secant = 1 / cos(sv->pitch), h = sv->gyroQ * sr + sv->gyroR * cr;

    sv->roll = 0.99 * (sv->roll + DT * (sv->gyroP + h * sp * secant));
    sv->yaw = wrapped(sv->yaw + DT * h * secant);
    sv->pitch = 0.99 * (sv->pitch + DT * (sv->gyroQ * cr - sv->gyroR * sr));
}

// Stores position, distance and direction.  Returns the speed over ground.
static inline double navigate(GuideSv *sv)
{
    const double level = sv->airspeed * cos(sv->pitch);
    const double north = level * cos(sv->yaw) + sv->windNorth, east = level * sin(sv->yaw) + sv->windEast;
    const double cosPad = cos(sv->padLat), sinPad = sin(sv->padLat);
    double sinLat, cosLat, halfLat, halfLon, wide, h;

    sv->track = atan2(east, north);
    sv->lat += DT / EARTH * north;
    sinLat = sin(sv->lat);
    cosLat = cos(sv->lat);
    sv->lon += DT / EARTH * east / cosLat;
    wide = sv->padLon - sv->lon;
    halfLat = sin((sv->padLat - sv->lat) / 2);
    halfLon = sin(wide / 2);
    h = halfLat * halfLat + cosLat * cosPad * halfLon * halfLon;
    sv->distance = 2 * EARTH * asin(fmin(sqrt(h), 1));
    sv->bearing = atan2(sin(wide) * cosPad, cosLat * sinPad - sinLat * cosPad * (1 - 2 * halfLon * halfLon));
    sv->density = 1.225f * expf((float)(sv->distance * (-1 / 8400.0)));
    return sqrt(north * north + east * east);
}

static void enter(GuideNative *m, GuideSv *sv)
{
    m->first = false;
    m->start = sv->time;
    sv->state = m->state;
    if (m->state == CIRCLE)
        sv->rounds = (uint16_t)(sv->rounds + (sv->rounds < UINT16_MAX));
    else
        sv->flare = m->state == FLARE;
}

// Returns the next state.
static inline uint32_t steer(const GuideNative *m, GuideSv *sv, double speed, double error)
{
    const uint64_t T = sv->time - m->start;

    if (m->state == HOME) {
        const float bank = atan2f((float)(speed * error * 0.3), 9.81f);
        sv->bank = bank < -0.8f ? -0.8f : bank > 0.8f ? 0.8f : bank;
        sv->rudder = (int16_t)(error * 2000);
        return sv->distance < 400 ? CIRCLE : HOME;
    }
    if (m->state == CIRCLE) {
        const double s = sin(error);
        sv->bank = atanf(sv->airspeed * sv->airspeed / (9.81f * (float)(sv->distance > 50 ? sv->distance : 50)));
        sv->rudder = (int16_t)(3000 * s - 500 * sin(2 * error));
        return sv->distance > 600 ? HOME : T > 4000 && fabs(error) < 0.3 ? FLARE : CIRCLE;
    }
    sv->bank = copysignf(0.1f * logf((float)(1 + sv->distance)), (float)error);
    sv->rudder = 0;
    return T > 2000 ? HOME : FLARE;
}

void guide_native_step(GuideNative *m, GuideSv *sv)
{
    double speed;
    uint32_t to;

    if (m->first)
        enter(m, sv);
    attitude(sv);
    speed = navigate(sv);
    to = steer(m, sv, speed, wrapped(sv->bearing - sv->track));
    m->first = to != m->state;
    m->state = to;
}
