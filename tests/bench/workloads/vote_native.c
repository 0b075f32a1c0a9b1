// SPDX-License-Identifier: Apache-2.0
// The vote as an expert writes it: floats, windows that do not branch on samples, and an exact running sum where samples are integers.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/vote.h"

enum { ALL = 1, TWO, FAILED };
enum { BAD = 10 };                                                       // steps

HAND_MEDIAN(Five, five, float, 5)
HAND_MEDIAN(Nine, nine, float, 9)
HAND_MEDIAN(Three, three, int16_t, 3)
HAND_ENDS(Fifteen, fifteen, float, 15)
HAND_ENDS(Twenty, twenty, float, 20)
HAND_AVERAGE(Fifty, fifty, float, 50)

static inline float less(float x, float y) { return x < y ? x : y; }
static inline float more(float x, float y) { return x > y ? x : y; }

void vote_native_init(VoteNative *m, VoteSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = ALL;
    m->first = true;
    sv->state = ALL;
}

static void put(VoteNative *m, const VoteSv *sv)
{
    const int left = m->t1_warm.n == 32 ? m->t1_warm.sample[m->t1_warm.next] : 0;

    five_put(&m->p1_five, sv->p1);
    five_put(&m->p2_five, sv->p2);
    five_put(&m->p3_five, sv->p3);
    twenty_put(&m->p1_twenty, sv->p1);
    twenty_put(&m->p2_twenty, sv->p2);
    twenty_put(&m->p3_twenty, sv->p3);
    fifty_put(&m->p1_fifty, sv->p1);
    nine_put(&m->a1_nine, sv->a1);
    fifteen_put(&m->a2_fifteen, sv->a2);
    fifty_put(&m->a2_fifty, sv->a2);
    three_put(&m->t2_three, sv->t2);
    warm_put(&m->t1_warm, sv->t1);
    m->t1_sum += sv->t1 - left;
}

static void medians(VoteNative *m)
{
    m->m1 = five_median(&m->p1_five);
    m->m2 = five_median(&m->p2_five);
    m->m3 = five_median(&m->p3_five);
}

static inline uint16_t count(uint16_t bad, float away)
{
    return (uint16_t)(fabsf(away) > 1.5f ? bad + (bad < UINT16_MAX) : 0);
}

static inline float range(const Twenty *w) { return twenty_most(w) - twenty_least(w); }

static void go_to(VoteNative *m, uint32_t state)
{
    m->state = state;
    m->first = true;
}

static void all(VoteNative *m, VoteSv *sv)
{
    float voted;

    medians(m);
    voted = more(less(m->m1, m->m2), less(more(m->m1, m->m2), m->m3));
    sv->voted = voted;
    sv->slow = fifty_average(&m->p1_fifty);
    sv->spread = range(&m->p2_twenty);
    sv->altitude = nine_median(&m->a1_nine);
    sv->band = fifteen_most(&m->a2_fifteen) - fifteen_least(&m->a2_fifteen);
    sv->doubt = sv->altitude - fifty_average(&m->a2_fifty);
    sv->warm = (float)m->t1_sum / (float)m->t1_warm.n;
    sv->jump = (int16_t)(three_median(&m->t2_three) - sv->t2);
    sv->bad1 = count(sv->bad1, m->m1 - voted);
    sv->bad2 = count(sv->bad2, m->m2 - voted);
    sv->bad3 = count(sv->bad3, m->m3 - voted);
    sv->healthy = (uint8_t)((sv->bad1 < BAD) + (sv->bad2 < BAD) + (sv->bad3 < BAD));
    sv->stuck = (range(&m->p1_twenty) == 0) | (range(&m->p3_twenty) == 0);
    sv->split = fabsf(sv->doubt) > 8;
    if (sv->healthy < 3)
        go_to(m, TWO);
}

static void two(VoteNative *m, VoteSv *sv)
{
    medians(m);
    sv->voted = (sv->bad1 >= BAD ? m->m2 + m->m3 : sv->bad2 >= BAD ? m->m1 + m->m3 : m->m1 + m->m2) / 2;
    sv->spread = range(&m->p2_twenty);
    sv->altitude = nine_median(&m->a1_nine);
    sv->band = fifteen_most(&m->a2_fifteen) - fifteen_least(&m->a2_fifteen);
    if (sv->spread > 6 || sv->band > 12)
        go_to(m, FAILED);
    else if (sv->reset && sv->time - m->start > 500)
        go_to(m, ALL);
}

void vote_native_step(VoteNative *m, VoteSv *sv)
{
    const bool first = m->first;

    if (first) {
        m->first = false;
        m->start = sv->time;
        sv->state = m->state;
    }
    put(m, sv);
    switch (m->state) {
    case ALL: all(m, sv); break;
    case TWO: two(m, sv); break;
    default:
        if (first)
            sv->voted = 0;
        sv->altitude = nine_median(&m->a1_nine);
        if (sv->reset) {
            sv->bad1 = sv->bad2 = sv->bad3 = 0;
            go_to(m, ALL);
        }
        break;
    }
}
