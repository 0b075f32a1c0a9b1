// SPDX-License-Identifier: Apache-2.0
// The pressure stand by the definitions of the language: every value a double, every store a conversion.  A condition that several calls of
// `held` wait for is sampled once.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/persist.h"

enum { IDLE = 1, FILL, SETTLE, READY, BURST, RELIEF };

void persist_f64_init(PersistF64 *m, PersistSv *sv)
{
    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    for (int i = 0; i < PRESSURES; i++)
        m->pressure[i].size = RATE_SIZE;
    m->drift.size = DRIFT_SIZE;
    window_init(&m->heat, m->heatSlot, HEAT_SIZE);
    sv->state = IDLE;
}

static void rate_put(PersistRate *w, double x, uint64_t time)
{
    w->slot[w->next] = x;
    w->time[w->next] = time;
    w->next = w->next + 1 < w->size ? w->next + 1 : 0;
    if (w->n < w->size)
        w->n++;
}

static double rate(const PersistRate *w)
{
    const uint32_t newest = (w->next + w->size - 1) % w->size, oldest = w->n < w->size ? 0 : w->next;

    if (w->n < 2)
        return 0;
    return (w->slot[newest] - w->slot[oldest]) / (I(w->time[newest] - w->time[oldest]) / 1000.0);
}

static void held_put(PersistF64 *m, int which, bool c, bool gap)
{
    PersistHeld *h = &m->held[which];

    if (!c) {
        h->on = false;
        h->samples = 0;
        return;
    }
    if (!h->on || gap)
        h->since = m->now;
    h->on = true;
    h->samples++;
}

static bool held(const PersistF64 *m, int which, uint64_t t)
{
    return m->held[which].on && m->now - m->held[which].since >= t;
}

// The samples of each pressure, in the order in which one needs another.
static void put_pressures(PersistF64 *m, const PersistSv *sv, bool gap)
{
    float p[PRESSURES];

    memcpy(p, &sv->p0, sizeof p);
    m->jump = false;
    for (int i = 0; i < PRESSURES; i++) {
        const double x = F(p[i]), before = m->ran ? m->before[i] : x;
        rate_put(&m->pressure[i], x, m->now);
        held_put(m, STUCK + i, x == before, gap);
        held_put(m, HIGH + i, x > 40.0, gap);
        held_put(m, LEAK + i, rate(&m->pressure[i]) < -25.0, gap);
        m->stuck[i] = held(m, STUCK + i, 60);
        m->high[i] = held(m, HIGH + i, 30);
        m->leak[i] = held(m, LEAK + i, 40);
        m->jump = m->jump || fabs(x - before) > 4.0;
        m->before[i] = x;
    }
}

static void put(PersistF64 *m, const PersistSv *sv, bool gap)
{
    put_pressures(m, sv, gap);
    window_put(&m->heat, F(sv->heat));
    rate_put(&m->drift, window_avg(&m->heat), m->now);
    held_put(m, ARMED, sv->armed, gap);
    held_put(m, LINKED, sv->link, gap);
    held_put(m, UNLINKED, !sv->link, gap);
    held_put(m, ALARM, sv->alarm, gap);
    held_put(m, FILLED, F(sv->p0) > 15.0, gap);
    held_put(m, NEAR, fabs(F(sv->p0) - F(sv->p3)) < 6.0, gap);
    held_put(m, CALM, fabs(rate(&m->pressure[0])) < 60.0, gap);
    held_put(m, CURRENT, I(sv->current) > 100.0, gap);
    held_put(m, FALLS, sv->vent && F(sv->slope) < 0.0, gap);
    held_put(m, VENTED, sv->vent, gap);
    m->pressed = sv->key && held(m, ARMED, 50);
    m->rosePress = m->ran && m->pressed && !m->lastPressed;
    m->roseKey = m->ran && sv->key && !m->keyWas;
    m->fellLink = m->ran && !sv->link && m->linkWas;
    m->fellArmed = m->ran && !sv->armed && m->armedWas;
    m->lastPressed = m->pressed;
    m->keyWas = sv->key;
    m->linkWas = sv->link;
    m->armedWas = sv->armed;
    m->ran = true;
}

static double sum(const bool *x) { return I(x[0]) + I(x[1]) + I(x[2]) + I(x[3]); }

static void all_states(PersistF64 *m, PersistSv *sv)
{
    sv->score = sm_to_u8(I(sv->score) + 40.0 * sum(m->stuck) + 25.0 * sum(m->high) + 60.0 * I(m->jump) - 3.0);
    sv->balance = sm_to_i8(I(sv->balance) + (I(m->leak[0]) + I(m->leak[1])) - (I(m->leak[2]) + I(m->leak[3])));
    sv->slope = sm_to_f32((rate(&m->pressure[0]) + rate(&m->pressure[1]) + rate(&m->pressure[2]) + rate(&m->pressure[3])) / 4.0);
    sv->drift = sm_to_f32(rate(&m->drift));
    sv->trend = sm_to_i16(I(sv->trend) + F(sv->drift) * 50.0);
    if (m->rosePress)
        sv->presses = sm_to_u16(I(sv->presses) + 1.0);
    if (m->fellLink)
        sv->lost = sm_to_u8(I(sv->lost) + 30.0);
    else if (held(m, LINKED, 200))
        sv->lost = sm_to_u8(I(sv->lost) - 1.0);
    sv->alarm = I(sv->score) > 200.0 || held(m, UNLINKED, 150) || I(sv->lost) == 255.0;
    sv->horn = held(m, ALARM, 100) && !held(m, ARMED, 500);
}

static void enter(const PersistF64 *m, PersistSv *sv)
{
    switch (m->frame.state) {
    case IDLE:
        sv->valve = false;
        sv->vent = false;
        break;
    case FILL:
        sv->valve = true;
        break;
    case SETTLE:
        sv->balance = 0;
        break;
    case RELIEF:
        sv->trend = 0;
        sv->vent = true;
        break;
    case BURST:
        sv->vent = true;
    }
}

static uint32_t fill(const PersistF64 *m, double T)
{
    if (held(m, FILLED, 30)) {
        if (m->high[1] || m->high[2])
            return RELIEF;
        if (held(m, NEAR, 20))
            return SETTLE;
        return T > 150.0 ? RELIEF : 0;
    }
    return T > 300.0 ? RELIEF : 0;
}

static uint32_t step(const PersistF64 *m, const PersistSv *sv)
{
    const double T = I(m->frame.T);

    switch (m->frame.state) {
    case IDLE:
        return held(m, ARMED, 50) && m->roseKey ? FILL : 0;
    case FILL:
        return fill(m, T);
    case SETTLE:
        if (m->leak[0] || m->leak[3])
            return RELIEF;
        return held(m, CALM, 30) && T >= 50.0 ? READY : T > 400.0 ? RELIEF : 0;
    case READY:
        if (sv->alarm || !held(m, LINKED, 20))
            return RELIEF;
        return m->held[CURRENT].samples >= 3 ? BURST : T > 500.0 ? RELIEF : 0;
    case BURST:
        return held(m, FALLS, 20) || T >= 100.0 ? RELIEF : 0;
    default:
        return (held(m, VENTED, 30) && m->fellArmed) || T >= 120.0 ? IDLE : 0;
    }
}

static void leave(const PersistF64 *m, PersistSv *sv)
{
    switch (m->frame.state) {
    case IDLE:
        sv->tries = sm_to_u8(I(sv->tries) + 1.0);
        break;
    case FILL:
        sv->valve = false;
        break;
    case BURST:
        sv->done = sm_to_u16(I(sv->done) + 1.0);
        sv->score = sm_to_u8(I(sv->score) / 2.0);
        break;
    case RELIEF:
        sv->lost = sm_to_u8(I(sv->lost) / 2.0);
        sv->vent = false;
    }
}

void persist_f64_step(PersistF64 *m, PersistSv *sv)
{
    const uint64_t last = m->frame.last;
    uint32_t to;

    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    m->now = sv->time;
    put(m, sv, m->ran && m->now - last > 20);
    if (m->frame.first)
        enter(m, sv);
    all_states(m, sv);
    to = step(m, sv);
    if (to != 0)
        leave(m, sv);
    frame_end(&m->frame, to);
}
