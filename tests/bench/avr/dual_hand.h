// SPDX-License-Identifier: Apache-2.0
// Compares altitudes as integers that have the order of the floats: an 8-bit chip does this faster.
#include <string.h>

#include "dual.h"
#include "tests/bench/avr/hand.h"

enum { PAD = 1, BOOST, COAST, DROGUE, MAIN, LANDED, AVERAGE_OF = 15, RANGE_OF = 20 };

HAND_SORTED(Nine, nine, int32_t, 9)

typedef struct DualHand {
    HandTime time;
    uint32_t state;
    float ground, top;
    Nine median;
    float acceleration[AVERAGE_OF];
    int32_t altitude[RANGE_OF];
    uint8_t accelerations, next_acceleration, altitudes, next_altitude;
} DualHand;

static int32_t key(float x)
{
    int32_t k;

    memcpy(&k, &x, sizeof k);
    return k < 0 ? k ^ INT32_MAX : k;
}

static float value(int32_t k)
{
    float x;

    k = k < 0 ? k ^ INT32_MAX : k;
    memcpy(&x, &k, sizeof x);
    return x;
}

static float not_nan(float x) { return x == x ? x : 0; }

static void put(DualHand *m, const DualSv *sv)
{
    const int32_t k = key(not_nan(sv->altitude));

    nine_put(&m->median, k);
    m->altitude[m->next_altitude] = k;
    m->next_altitude = m->next_altitude + 1 < RANGE_OF ? m->next_altitude + 1 : 0;
    m->altitudes += m->altitudes < RANGE_OF;
    m->acceleration[m->next_acceleration] = not_nan(sv->acceleration);
    m->next_acceleration = m->next_acceleration + 1 < AVERAGE_OF ? m->next_acceleration + 1 : 0;
    m->accelerations += m->accelerations < AVERAGE_OF;
}

static float median(const DualHand *m)
{
    const uint8_t n = m->median.n;

    if (n % 2 != 0)
        return value(m->median.sorted[n / 2]);
    return (value(m->median.sorted[n / 2 - 1]) + value(m->median.sorted[n / 2])) / 2;
}

static float average(const DualHand *m)
{
    float sum = 0;

    for (uint8_t i = 0; i < m->accelerations; i++)
        sum += m->acceleration[i];
    return sum / m->accelerations;
}

static float range(const DualHand *m)
{
    int32_t least = m->altitude[0], most = least;

    for (uint8_t i = 1; i < m->altitudes; i++) {
        const int32_t k = m->altitude[i];
        if (k < least)
            least = k;
        else if (k > most)
            most = k;
    }
    return value(most) - value(least);
}

static void dual_hand_init(DualHand *m, DualSv *sv)
{
    m->time.first = true;
    m->state = PAD;
    sv->state = PAD;
}

static uint32_t next_state(DualHand *m, DualSv *sv, bool first)
{
    const uint64_t t = sv->time - m->time.start;
    float height;

    switch (m->state) {
    case PAD:
        m->ground = median(m);
        return average(m) > 20 ? BOOST : 0;
    case BOOST:
        height = median(m);
        if (first)
            m->top = m->ground;
        m->top = height > m->top ? height : m->top;
        return t > 500 && average(m) < 0 ? COAST : 0;
    case COAST:
        height = median(m);
        m->top = height > m->top ? height : m->top;
        return height < m->top - 4 || t > 30000 ? DROGUE : 0;
    case DROGUE:
        if (first)
            sv->drogue = true;
        return median(m) - m->ground < 150 || t > 60000 ? MAIN : 0;
    case MAIN:
        if (first)
            sv->mainChute = true;
        return t > 5000 && range(m) < 2 ? LANDED : 0;
    default:
        return 0;
    }
}

static void dual_hand_step(DualHand *m, DualSv *sv)
{
    const bool first = m->time.first;
    uint32_t to;

    if (!hand_time(&m->time, sv->time))
        return;
    if (first)
        sv->state = m->state;
    put(m, sv);
    to = next_state(m, sv, first);
    m->time.first = to != 0;
    if (to != 0)
        m->state = to;
}
