// SPDX-License-Identifier: Apache-2.0
#include "median.h"
#include "tests/bench/avr/hand.h"

HAND_SORTED(Nine, nine, int16_t, 9)

typedef struct MedianHand { HandTime time; Nine raw; } MedianHand;

static void median_hand_init(MedianHand *m, MedianSv *sv)
{
    m->time.first = true;
    sv->state = 1;
}

static void median_hand_step(MedianHand *m, MedianSv *sv)
{
    const Nine *w = &m->raw;

    if (!hand_time(&m->time, sv->time))
        return;
    if (m->time.first) {
        m->time.first = false;
        sv->state = 1;
    }
    nine_put(&m->raw, sv->raw);
    sv->clean = w->n % 2 != 0 ? w->sorted[w->n / 2] : (int16_t)(((int32_t)w->sorted[w->n / 2 - 1] + w->sorted[w->n / 2]) / 2);
}
