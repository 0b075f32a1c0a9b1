// SPDX-License-Identifier: Apache-2.0
// The Kalman filter as an expert writes it: the covariance in registers during a step.  The only divisor that can be 0 is tested, and a
// measurement of variance 0 is no special case beyond that.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/kalman.h"

enum { PAD = 1, BOOST, COAST, DESCENT };

typedef struct Covariance { double p00, p01, p02, p11, p12, p22; } Covariance;
typedef struct Estimate { double height, speed, bias; } Estimate;

void kalman_native_init(KalmanNative *m, KalmanSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = PAD;
    m->first = true;
    m->p00 = 100;
    m->p11 = 10;
    m->p22 = 1;
    sv->state = PAD;
}

// s: the variance of the innovation y.  If it is 0, the height is known exactly, and the measurement changes nothing.
static inline void update(Covariance *p, Estimate *x, double y, double s)
{
    double k0, k1, k2;

    if (s == 0)
        return;
    k0 = p->p00 / s;
    k1 = p->p01 / s;
    k2 = p->p02 / s;
    x->height += k0 * y;
    x->speed += k1 * y;
    x->bias += k2 * y;
    p->p22 -= k2 * p->p02;
    p->p12 -= k1 * p->p02;
    p->p11 -= k1 * p->p01;
    p->p02 *= 1 - k0;
    p->p01 *= 1 - k0;
    p->p00 *= 1 - k0;
}

static inline Covariance predicted(const KalmanNative *m, double dt, double e)
{
    const double a01 = m->p01 + dt * m->p11 - e * m->p12;
    const double a02 = m->p02 + dt * m->p12 - e * m->p22;
    const double a12 = m->p12 - dt * m->p22;
    Covariance p;

    p.p00 = m->p00 + dt * m->p01 - e * m->p02 + dt * a01 - e * a02 + m->q * e * e;
    p.p01 = a01 - dt * a02 + m->q * e * dt;
    p.p02 = a02;
    p.p11 = m->p11 - dt * m->p12 - dt * a12 + m->q * dt * dt;
    p.p12 = a12;
    p.p22 = m->p22 + 0.0001 * dt;
    return p;
}

// Returns the acceleration without the bias that was estimated before.
static double filter(KalmanNative *m, KalmanSv *sv)
{
    const double dt = (double)(sv->time - m->last) / 1000, e = dt * dt / 2, a = sv->accel - sv->bias;
    Estimate x = {sv->height + sv->speed * dt + a * e, sv->speed + a * dt, sv->bias};
    Covariance p = predicted(m, dt, e);
    const double y = sv->baro - x.height, s = p.p00 + sv->baroVar, d = s != 0 || y != 0 ? y * y / s : 0;

    m->last = sv->time;
    sv->nis = d < 100 ? d : 100;
    if (d < 16 || m->misses > 20) {
        m->misses = 0;
        update(&p, &x, y, s);
    } else {
        m->misses++;
        if (sv->rejected < UINT16_MAX)
            sv->rejected++;
    }
    if (sv->fix)
        update(&p, &x, sv->gps - x.height, p.p00 + sv->gpsVar);
    sv->height = x.height;
    sv->speed = x.speed;
    sv->bias = x.bias;
    sv->sigma = sqrt(p.p00);
    memcpy(&m->p00, &p, sizeof p);                       // the fields are adjacent
    return a;
}

static void enter(KalmanNative *m, KalmanSv *sv)
{
    static const double noise[] = {0, 1, 400, 25, 100};

    m->first = false;
    m->start = sv->time;
    m->q = noise[m->state];
    sv->state = m->state;
    if (m->state == PAD || m->state == DESCENT)
        sv->drogue = m->state == DESCENT;
}

void kalman_native_step(KalmanNative *m, KalmanSv *sv)
{
    bool done = false;
    double a;

    if (m->first)
        enter(m, sv);
    a = filter(m, sv);
    switch (m->state) {
    case PAD: done = a > 20 && sv->speed > 5; break;
    case BOOST: done = a < 0 && sv->time - m->start > 500; break;
    case COAST: done = sv->speed + 2 * sqrt(m->p11) < 0; break;
    default: done = fabs(sv->speed) < 3 && sv->height < 30 && sv->time - m->start > 2000;
    }
    if (done) {
        m->state = m->state == DESCENT ? PAD : m->state + 1;
        m->first = true;
    }
}
