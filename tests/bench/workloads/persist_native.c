// SPDX-License-Identifier: Apache-2.0
// The pressure stand as an expert writes it: each condition has the time since which it is true, updated without branches, and each pressure one
// ring.  The mean of the temperatures is a sum of eleven slots, empty ones 0.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/persist.h"

enum { IDLE = 1, FILL, SETTLE, READY, BURST, RELIEF };

typedef struct Edges { bool pressed, key, link, armed, jump; float rate[PRESSURES]; } Edges;

void persist_native_init(PersistNative *m, PersistSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = IDLE;
    m->first = true;
    for (int i = 0; i < CONDITIONS; i++)
        m->since[i] = UINT64_MAX;
    sv->state = IDLE;
}

static inline void note(PersistNative *m, int which, bool c, uint64_t now)
{
    const uint64_t since = m->since[which] < now ? m->since[which] : now;

    m->since[which] = c ? since : UINT64_MAX;
}

// t: ms.
static inline bool held(const PersistNative *m, int which, uint64_t now, uint64_t t)
{
    return m->since[which] <= now && now - m->since[which] >= t;
}

static inline void pressures(PersistNative *m, const PersistSv *sv, uint64_t now, Edges *e)
{
    const unsigned newest = m->n % RATE_SIZE, oldest = m->n < RATE_SIZE ? 0 : (m->n + 1) % RATE_SIZE;
    float p[PRESSURES], perSecond;
    bool jump = false;

    memcpy(p, &sv->p0, sizeof p);
    memcpy(m->p[newest], p, sizeof p);
    m->pTime[newest] = now;
    perSecond = m->n > 0 ? 1000 / (float)(now - m->pTime[oldest]) : 0;
    for (int i = 0; i < PRESSURES; i++) {
        const float before = m->n > 0 ? m->before[i] : p[i];
        e->rate[i] = (p[i] - m->p[oldest][i]) * perSecond;
        note(m, STUCK + i, p[i] == before, now);
        note(m, HIGH + i, p[i] > 40, now);
        note(m, LEAK + i, e->rate[i] < -25, now);
        jump |= fabsf(p[i] - before) > 4;
        m->before[i] = p[i];
    }
    e->jump = jump;
    m->n++;
    if (m->n == 2 * RATE_SIZE)
        m->n = RATE_SIZE;
}

// Stores the mean temperature, and returns its rate.
static inline float drift(PersistNative *m, float heat, uint64_t now)
{
    const unsigned newest = m->drifts % DRIFT_SIZE, oldest = m->drifts < DRIFT_SIZE ? 0 : (m->drifts + 1) % DRIFT_SIZE;
    double sum = 0;

    m->heat[m->heats % HEAT_SIZE] = heat;
    m->heats = m->heats + 1 == 2 * HEAT_SIZE ? HEAT_SIZE : m->heats + 1;
    for (int i = 0; i < HEAT_SIZE; i++)
        sum += m->heat[i];
    m->mean[newest] = sum / (m->heats < HEAT_SIZE ? m->heats : HEAT_SIZE);
    m->driftTime[newest] = now;
    m->drifts = m->drifts + 1 == 2 * DRIFT_SIZE ? DRIFT_SIZE : m->drifts + 1;
    return newest == oldest ? 0 : (float)((m->mean[newest] - m->mean[oldest]) * 1000 / (double)(now - m->driftTime[oldest]));
}

static inline void sample(PersistNative *m, const PersistSv *sv, uint64_t now, Edges *e)
{
    bool pressed;

    pressures(m, sv, now, e);
    note(m, ARMED, sv->armed, now);
    note(m, LINKED, sv->link, now);
    note(m, UNLINKED, !sv->link, now);
    note(m, ALARM, sv->alarm, now);
    note(m, FILLED, sv->p0 > 15, now);
    note(m, NEAR, fabsf(sv->p0 - sv->p3) < 6, now);
    note(m, CALM, fabsf(e->rate[0]) < 60, now);
    note(m, FALLS, sv->vent && sv->slope < 0, now);
    note(m, VENTED, sv->vent, now);
    m->currents = sv->current > 100 ? m->currents + 1 : 0;
    pressed = sv->key && held(m, ARMED, now, 50);
    e->pressed = m->ran & pressed & !m->lastPressed;
    e->key = m->ran & sv->key & !m->lastKey;
    e->link = m->ran & !sv->link & m->lastLink;
    e->armed = m->ran & !sv->armed & m->lastArmed;
    m->lastPressed = pressed;
    m->lastKey = sv->key;
    m->lastLink = sv->link;
    m->lastArmed = sv->armed;
    m->ran = true;
}

static inline int limited(int x, int least, int most) { return x < least ? least : x > most ? most : x; }

static inline void all_states(PersistNative *m, PersistSv *sv, uint64_t now, const Edges *e)
{
    int score = sv->score - 3 + 60 * e->jump, balance = sv->balance;

    for (int i = 0; i < PRESSURES; i++) {
        score += 40 * held(m, STUCK + i, now, 60) + 25 * held(m, HIGH + i, now, 30);
        balance += i < 2 ? held(m, LEAK + i, now, 40) : -held(m, LEAK + i, now, 40);
    }
    sv->score = (uint8_t)limited(score, 0, UINT8_MAX);
    sv->balance = (int8_t)limited(balance, INT8_MIN, INT8_MAX);
    sv->slope = (e->rate[0] + e->rate[1] + e->rate[2] + e->rate[3]) / 4;
    sv->drift = drift(m, sv->heat, now);
    sv->trend = (int16_t)limited((int)(sv->trend + sv->drift * 50.0), INT16_MIN, INT16_MAX);
    sv->presses = (uint16_t)(sv->presses + (e->pressed && sv->presses < UINT16_MAX));
    if (e->link)
        sv->lost = (uint8_t)limited(sv->lost + 30, 0, UINT8_MAX);
    else if (held(m, LINKED, now, 200))
        sv->lost = (uint8_t)(sv->lost - (sv->lost > 0));
    sv->alarm = sv->score > 200 || held(m, UNLINKED, now, 150) || sv->lost == UINT8_MAX;
    sv->horn = held(m, ALARM, now, 100) && !held(m, ARMED, now, 500);
}

static void enter(PersistNative *m, PersistSv *sv, uint64_t now)
{
    m->first = false;
    m->start = now;
    sv->state = m->state;
    switch (m->state) {
    case IDLE: sv->valve = sv->vent = false; break;
    case FILL: sv->valve = true; break;
    case SETTLE: sv->balance = 0; break;
    case RELIEF: sv->trend = 0;              // fall through
    case BURST: sv->vent = true;
    }
}

// Returns the next state.
static inline uint32_t next(const PersistNative *m, const PersistSv *sv, uint64_t now, const Edges *e)
{
    const uint64_t T = now - m->start;

    switch (m->state) {
    case IDLE:
        return e->key && held(m, ARMED, now, 50) ? FILL : IDLE;
    case FILL:
        if (!held(m, FILLED, now, 30))
            return T > 300 ? RELIEF : FILL;
        if (held(m, HIGH + 1, now, 30) || held(m, HIGH + 2, now, 30))
            return RELIEF;
        return held(m, NEAR, now, 20) ? SETTLE : T > 150 ? RELIEF : FILL;
    case SETTLE:
        if (held(m, LEAK, now, 40) || held(m, LEAK + 3, now, 40))
            return RELIEF;
        return T >= 50 && held(m, CALM, now, 30) ? READY : T > 400 ? RELIEF : SETTLE;
    case READY:
        if (sv->alarm || !held(m, LINKED, now, 20))
            return RELIEF;
        return m->currents >= 3 ? BURST : T > 500 ? RELIEF : READY;
    case BURST:
        return T >= 100 || held(m, FALLS, now, 20) ? RELIEF : BURST;
    default:
        return T >= 120 || (e->armed && held(m, VENTED, now, 30)) ? IDLE : RELIEF;
    }
}

static void leave(const PersistNative *m, PersistSv *sv)
{
    switch (m->state) {
    case IDLE: sv->tries = (uint8_t)(sv->tries + (sv->tries < UINT8_MAX)); break;
    case FILL: sv->valve = false; break;
    case BURST: sv->done = (uint16_t)(sv->done + (sv->done < UINT16_MAX)); sv->score /= 2; break;
    case RELIEF: sv->lost /= 2; sv->vent = false;
    }
}

void persist_native_step(PersistNative *m, PersistSv *sv)
{
    const uint64_t now = sv->time;
    uint32_t to;
    Edges e;

    if (m->ran && now - m->last > 20)                    // after a gap each true condition begins again
        for (int i = 0; i < CONDITIONS; i++)
            m->since[i] = UINT64_MAX;
    m->last = now;
    sample(m, sv, now, &e);
    if (m->first)
        enter(m, sv, now);
    all_states(m, sv, now, &e);
    to = next(m, sv, now, &e);
    if (to != m->state) {
        leave(m, sv);
        m->state = to;
        m->first = true;
    }
}
