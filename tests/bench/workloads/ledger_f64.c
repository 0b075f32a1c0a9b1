// SPDX-License-Identifier: Apache-2.0
// The sixteen channels by the definitions of the language: every value a double, every store a conversion.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/ledger.h"

enum { LEDGER = 1, CLEAR };

void ledger_f64_init(LedgerF64 *m, LedgerSv *sv)
{
    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    sv->state = LEDGER;
}

static void channel(LedgerF64 *m, LedgerSv *sv, int i, int32_t in)
{
    m->p[i] = sm_to_i64(I(m->p[i]) + I(in) * I(i + 3));
    m->d[i] = sm_to_u64(I(m->d[i]) + fabs(I(in) - I(m->l[i])));
    m->l[i] = sm_to_i32(I(in));
    if (fabs(I(m->p[i])) > I(m->k[i]))
        m->k[i] = sm_to_i64(fabs(I(m->p[i])));
    if (I(sv->time) >= I(m->n[i])) {
        m->n[i] = sm_to_u64(I(sv->time) + 7000.0 * I(i + 1));
        sv->late = sm_to_u32(I(sv->late) + 1.0);
    }
}

static uint32_t ledger(LedgerF64 *m, LedgerSv *sv)
{
    double position = 0, distance = 0;
    int32_t in[CHANNELS];

    memcpy(in, &sv->in0, sizeof in);
    for (int i = 0; i < CHANNELS; i++)
        channel(m, sv, i, in[i]);
    for (int i = 0; i < CHANNELS; i++) {
        position += I(m->p[i]);
        distance += I(m->d[i]);
    }
    sv->position = sm_to_i64(position);
    sv->distance = sm_to_u64(distance);
    sv->worst = 0;
    for (int i = 0; i < CHANNELS; i++)
        if (I(m->k[i]) > I(sv->worst))
            sv->worst = sm_to_i64(I(m->k[i]));
    sv->mean = sm_to_i32(I(sv->position) / 1000.0);
    sv->age = sm_to_u64(I(sv->time) - I(m->frame.T) + I(sv->distance) * 3.0);
    sv->checks = sm_to_u64(I(sv->checks) + I(sv->distance) / 16.0);
    sv->full = I(sv->distance) > 4000000000.0 || I(sv->worst) > 9000000000.0;
    return sv->clear ? CLEAR : 0;
}

void ledger_f64_step(LedgerF64 *m, LedgerSv *sv)
{
    uint32_t to = LEDGER;

    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    if (m->frame.state == LEDGER) {
        to = ledger(m, sv);
    } else {
        memset(m->p, 0, sizeof m->p);
        memset(m->d, 0, sizeof m->d);
        memset(m->k, 0, sizeof m->k);
    }
    frame_end(&m->frame, to);
}
