// SPDX-License-Identifier: Apache-2.0
// The vote by the definitions of the language: every value a double, every store a conversion, windows of doubles whose statistics are
// computed again at each use.
#include <math.h>

#include "tests/bench/workloads/vote.h"

enum { ALL = 1, TWO, FAILED };
enum { P1_5, P2_5, P3_5, P1_20, P2_20, P3_20, P1_50, A1_9, A2_15, A2_50, T2_3, T1_32 };

#define T ((double)m->frame.T)
#define MEDIAN(k) window_median(&m->window[k])
#define RANGE(k) window_range(&m->window[k])

void vote_f64_init(VoteF64 *m, VoteSv *sv)
{
    static const uint32_t size[VOTE_WINDOWS] = {5, 5, 5, 20, 20, 20, 50, 9, 15, 50, 3, 32};

    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    for (int i = 0; i < VOTE_WINDOWS; i++)
        window_init(&m->window[i], m->slot[i], size[i]);
    sv->state = ALL;
}

static void put(VoteF64 *m, const VoteSv *sv)
{
    const double x[VOTE_WINDOWS] = {F(sv->p1), F(sv->p2), F(sv->p3), F(sv->p1), F(sv->p2), F(sv->p3), F(sv->p1),
                                    F(sv->a1), F(sv->a2), F(sv->a2), I(sv->t2), I(sv->t1)};

    for (int i = 0; i < VOTE_WINDOWS; i++)
        window_put(&m->window[i], x[i]);
}

static void medians(VoteF64 *m)
{
    m->m1 = sm_to_f32(MEDIAN(P1_5));
    m->m2 = sm_to_f32(MEDIAN(P2_5));
    m->m3 = sm_to_f32(MEDIAN(P3_5));
}

static void compare(const VoteF64 *m, VoteSv *sv)
{
    sv->spread = sm_to_f32(RANGE(P2_20));
    sv->altitude = sm_to_f32(MEDIAN(A1_9));
    sv->band = sm_to_f32(window_max(&m->window[A2_15]) - window_min(&m->window[A2_15]));
}

static uint16_t count(uint16_t bad, float sensor, float voted)
{
    return fabs(F(sensor) - F(voted)) > 1.5 ? sm_to_u16(I(bad) + 1.0) : 0;
}

static uint32_t all(VoteF64 *m, VoteSv *sv)
{
    medians(m);
    sv->voted = sm_to_f32(sm_max(sm_min(F(m->m1), F(m->m2)), sm_min(sm_max(F(m->m1), F(m->m2)), F(m->m3))));
    sv->slow = sm_to_f32(window_avg(&m->window[P1_50]));
    compare(m, sv);
    sv->doubt = sm_to_f32(F(sv->altitude) - window_avg(&m->window[A2_50]));
    sv->warm = sm_to_f32(window_avg(&m->window[T1_32]));
    sv->jump = sm_to_i16(MEDIAN(T2_3) - I(sv->t2));
    sv->bad1 = count(sv->bad1, m->m1, sv->voted);
    sv->bad2 = count(sv->bad2, m->m2, sv->voted);
    sv->bad3 = count(sv->bad3, m->m3, sv->voted);
    sv->healthy = sm_to_u8(I(I(sv->bad1) < 10.0) + I(I(sv->bad2) < 10.0) + I(I(sv->bad3) < 10.0));
    sv->stuck = RANGE(P1_20) == 0.0 || RANGE(P3_20) == 0.0;
    sv->split = fabs(F(sv->doubt)) > 8.0;
    return I(sv->healthy) < 3.0 ? TWO : 0;
}

static uint32_t two(VoteF64 *m, VoteSv *sv)
{
    medians(m);
    if (I(sv->bad1) >= 10.0)
        sv->voted = sm_to_f32((F(m->m2) + F(m->m3)) / 2.0);
    else if (I(sv->bad2) >= 10.0)
        sv->voted = sm_to_f32((F(m->m1) + F(m->m3)) / 2.0);
    else
        sv->voted = sm_to_f32((F(m->m1) + F(m->m2)) / 2.0);
    compare(m, sv);
    if (F(sv->spread) > 6.0 || F(sv->band) > 12.0)
        return FAILED;
    return sv->reset && T > 500.0 ? ALL : 0;
}

static uint32_t failed(VoteF64 *m, VoteSv *sv)
{
    if (m->frame.first)
        sv->voted = 0;
    sv->altitude = sm_to_f32(MEDIAN(A1_9));
    if (!sv->reset)
        return 0;
    sv->bad1 = 0;
    sv->bad2 = 0;
    sv->bad3 = 0;
    return ALL;
}

void vote_f64_step(VoteF64 *m, VoteSv *sv)
{
    uint32_t to;

    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    put(m, sv);
    switch (m->frame.state) {
    case ALL: to = all(m, sv); break;
    case TWO: to = two(m, sv); break;
    default: to = failed(m, sv); break;
    }
    frame_end(&m->frame, to);
}
