// SPDX-License-Identifier: Apache-2.0
// The Kalman filter by the definitions of the language: every store of a double turns NaN into 0.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/kalman.h"

enum { PAD = 1, BOOST, COAST, DESCENT };

void kalman_f64_init(KalmanF64 *m, KalmanSv *sv)
{
    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    m->q = 0.01;
    m->p00 = 100;
    m->p11 = 10;
    m->p22 = 1;
    sv->state = PAD;
}

static void predict(KalmanF64 *m, KalmanSv *sv)
{
    m->dt = sm_to_f64((I(sv->time) - I(m->last)) / 1000.0);
    m->last = sm_to_u64(I(sv->time));
    m->e = sm_to_f64(D(m->dt) * D(m->dt) / 2.0);
    m->a = sm_to_f64(D(sv->accel) - D(sv->bias));
    sv->height = sm_to_f64(D(sv->height) + D(sv->speed) * D(m->dt) + D(m->a) * D(m->e));
    sv->speed = sm_to_f64(D(sv->speed) + D(m->a) * D(m->dt));
    m->a00 = sm_to_f64(D(m->p00) + D(m->dt) * D(m->p01) - D(m->e) * D(m->p02));
    m->a01 = sm_to_f64(D(m->p01) + D(m->dt) * D(m->p11) - D(m->e) * D(m->p12));
    m->a02 = sm_to_f64(D(m->p02) + D(m->dt) * D(m->p12) - D(m->e) * D(m->p22));
    m->a11 = sm_to_f64(D(m->p11) - D(m->dt) * D(m->p12));
    m->a12 = sm_to_f64(D(m->p12) - D(m->dt) * D(m->p22));
    m->p00 = sm_to_f64(D(m->a00) + D(m->dt) * D(m->a01) - D(m->e) * D(m->a02) + D(m->q) * D(m->e) * D(m->e));
    m->p01 = sm_to_f64(D(m->a01) - D(m->dt) * D(m->a02) + D(m->q) * D(m->e) * D(m->dt));
    m->p02 = sm_to_f64(D(m->a02));
    m->p11 = sm_to_f64(D(m->a11) - D(m->dt) * D(m->a12) + D(m->q) * D(m->dt) * D(m->dt));
    m->p12 = sm_to_f64(D(m->a12));
    m->p22 = sm_to_f64(D(m->p22) + 0.0001 * D(m->dt));
}

static void update(KalmanF64 *m, KalmanSv *sv)
{
    m->k0 = sm_to_f64(D(m->p00) / D(m->s));
    m->k1 = sm_to_f64(D(m->p01) / D(m->s));
    m->k2 = sm_to_f64(D(m->p02) / D(m->s));
    sv->height = sm_to_f64(D(sv->height) + D(m->k0) * D(m->y));
    sv->speed = sm_to_f64(D(sv->speed) + D(m->k1) * D(m->y));
    sv->bias = sm_to_f64(D(sv->bias) + D(m->k2) * D(m->y));
    m->p22 = sm_to_f64(D(m->p22) - D(m->k2) * D(m->p02));
    m->p12 = sm_to_f64(D(m->p12) - D(m->k1) * D(m->p02));
    m->p11 = sm_to_f64(D(m->p11) - D(m->k1) * D(m->p01));
    m->p02 = sm_to_f64((1.0 - D(m->k0)) * D(m->p02));
    m->p01 = sm_to_f64((1.0 - D(m->k0)) * D(m->p01));
    m->p00 = sm_to_f64((1.0 - D(m->k0)) * D(m->p00));
}

static void measure(KalmanF64 *m, KalmanSv *sv)
{
    m->y = sm_to_f64(D(sv->baro) - D(sv->height));
    m->s = sm_to_f64(D(m->p00) + D(sv->baroVar));
    m->d = sm_to_f64(D(m->y) * D(m->y) / D(m->s));
    sv->nis = sm_to_f64(sm_min(D(m->d), 100.0));
    if (D(m->d) < 16.0 || I(m->misses) > 20.0) {
        m->misses = 0;
        update(m, sv);
    } else {
        m->misses = sm_to_u8(I(m->misses) + 1.0);
        sv->rejected = sm_to_u16(I(sv->rejected) + 1.0);
    }
    if (sv->fix) {
        m->y = sm_to_f64(D(sv->gps) - D(sv->height));
        m->s = sm_to_f64(D(m->p00) + D(sv->gpsVar));
        update(m, sv);
    }
    sv->sigma = sm_to_f64(sqrt(D(m->p00)));
}

static void enter(KalmanF64 *m, KalmanSv *sv)
{
    static const double noise[] = {0, 1, 400, 25, 100};

    m->q = noise[m->frame.state];
    if (m->frame.state == PAD)
        sv->drogue = false;
    if (m->frame.state == DESCENT)
        sv->drogue = true;
}

static uint32_t next(const KalmanF64 *m, const KalmanSv *sv)
{
    const double T = I(m->frame.T);

    switch (m->frame.state) {
    case PAD:
        return D(m->a) > 20.0 && D(sv->speed) > 5.0 ? BOOST : 0;
    case BOOST:
        return D(m->a) < 0.0 && T > 500.0 ? COAST : 0;
    case COAST:
        return D(sv->speed) + 2.0 * sqrt(D(m->p11)) < 0.0 ? DESCENT : 0;
    default:
        return fabs(D(sv->speed)) < 3.0 && D(sv->height) < 30.0 && T > 2000.0 ? PAD : 0;
    }
}

void kalman_f64_step(KalmanF64 *m, KalmanSv *sv)
{
    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    if (m->frame.first)
        enter(m, sv);
    predict(m, sv);
    measure(m, sv);
    frame_end(&m->frame, next(m, sv));
}
