// SPDX-License-Identifier: Apache-2.0
// The large window by the definitions of the language: -0 precedes +0, NaN is read as 0, the middle of two samples does not overflow.  Otherwise
// like bigwindow_native.c.
#include <math.h>

#include "stdlib/f64.h"
#include "tests/bench/workloads/bigwindow.h"

void bigwindow_f64_init(BigwindowF64 *m, BigwindowSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = 1;
    m->first = true;
    sv->state = 1;
}

static bool comes_before(double x, double y)
{
    return x < y || (x == y && sm_bits(x) > sm_bits(y));
}

static uint32_t place(const BigwindowF64 *m, double x)
{
    uint32_t lo = 0, hi = m->n;

    while (lo < hi) {
        const uint32_t mid = (lo + hi) / 2;
        if (comes_before(m->sorted[mid], x))
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

static void put(BigwindowF64 *m, double x)
{
    const uint32_t from = m->n < WINDOW_OF ? m->n : place(m, m->slot[m->next]);
    uint32_t to = place(m, x);

    if (from < to) {
        to--;
        memmove(m->sorted + from, m->sorted + from + 1, (to - from) * sizeof *m->sorted);
    } else {
        memmove(m->sorted + to + 1, m->sorted + to, (from - to) * sizeof *m->sorted);
    }
    m->sorted[to] = x;
    m->slot[m->next] = x;
    m->next = m->next + 1 < WINDOW_OF ? m->next + 1 : 0;
    if (m->n < WINDOW_OF)
        m->n++;
}

static double median(const BigwindowF64 *m)
{
    const double a = m->sorted[(m->n - 1) / 2], b = m->sorted[m->n / 2], d = b - a;

    if (a == b)
        return a;
    return d < HUGE_VAL ? a + d / 2 : a / 2 + b / 2;
}

void bigwindow_f64_step(BigwindowF64 *m, BigwindowSv *sv)
{
    if (sv->time == UINT64_MAX || (m->ran && sv->time <= m->last))
        return;
    m->ran = true;
    m->last = sv->time;
    if (m->first) {
        m->start = sv->time;
        sv->state = m->state;
    }
    m->T = sv->time - m->start;
    m->first = false;
    put(m, sv->pressure != sv->pressure ? 0.0 : sv->pressure);
    sv->middle = median(m);
    sv->low = m->sorted[0];
    sv->high = m->sorted[m->n - 1];
}
