// SPDX-License-Identifier: Apache-2.0
// The sixteen channels as a flight-software engineer writes them: arrays, a loop, and 64-bit integers, which no value here can overflow.
#include <string.h>

#include "tests/bench/workloads/ledger.h"

enum { LEDGER = 1, CLEAR };

void ledger_native_init(LedgerNative *m, LedgerSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = LEDGER;
    m->first = true;
    sv->state = LEDGER;
}

static void ledger(LedgerNative *m, LedgerSv *sv)
{
    int32_t in[CHANNELS];
    int64_t position = 0, worst = 0;
    uint64_t distance = 0;
    uint32_t late = 0;

    memcpy(in, &sv->in0, sizeof in);                             // the elements are adjacent
    for (int i = 0; i < CHANNELS; i++) {
        const int64_t moved = (int64_t)in[i] - m->last[i];
        const int64_t p = m->position[i] + (int64_t)in[i] * (i + 3), size = p < 0 ? -p : p;

        m->position[i] = p;
        m->distance[i] += (uint64_t)(moved < 0 ? -moved : moved);
        m->last[i] = in[i];
        m->peak[i] = size > m->peak[i] ? size : m->peak[i];
        if (sv->time >= m->next[i]) {
            m->next[i] = sv->time + 7000 * (uint64_t)(i + 1);
            late++;
        }
        position += p;
        distance += m->distance[i];
        worst = m->peak[i] > worst ? m->peak[i] : worst;
    }
    sv->late += late;
    sv->position = position;
    sv->distance = distance;
    sv->worst = worst;
    sv->mean = (int32_t)(position / 1000);
    sv->age = m->start + distance * 3;
    sv->checks += distance / 16;
    sv->full = (distance > 4000000000) | (worst > 9000000000);
    if (sv->clear) {
        m->state = CLEAR;
        m->first = true;
    }
}

void ledger_native_step(LedgerNative *m, LedgerSv *sv)
{
    if (m->first) {
        m->first = false;
        m->start = sv->time;
        sv->state = m->state;
    }
    if (m->state == LEDGER) {
        ledger(m, sv);
        return;
    }
    memset(m->position, 0, sizeof m->position);
    memset(m->distance, 0, sizeof m->distance);
    memset(m->peak, 0, sizeof m->peak);
    m->state = LEDGER;
    m->first = true;
}
