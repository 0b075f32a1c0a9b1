// SPDX-License-Identifier: Apache-2.0
// The large window as a flight-software engineer writes it: a ring, and a sorted copy of the same samples.  Binary search finds the positions of
// the old and the new sample.  The samples between them move by one.
#include <string.h>

#include "tests/bench/workloads/bigwindow.h"

void bigwindow_native_init(BigwindowNative *m, BigwindowSv *sv)
{
    memset(m, 0, sizeof *m);
    m->first = true;
    sv->state = 1;
}

// Returns how many samples are less than x, without branches that depend on samples.
static unsigned place(const double *sorted, unsigned n, double x)
{
    unsigned at = 0;

    for (; n > 1; n -= n / 2)
        at += n / 2 * (sorted[at + n / 2 - 1] < x);
    return at + (n != 0 && sorted[at] < x);
}

static void put(BigwindowNative *m, double x)
{
    const unsigned from = m->n < WINDOW_OF ? m->n : place(m->sorted, m->n, m->sample[m->next]);
    unsigned to = place(m->sorted, m->n, x);

    if (from < to) {
        to--;
        memmove(m->sorted + from, m->sorted + from + 1, (to - from) * sizeof *m->sorted);
    } else {
        memmove(m->sorted + to + 1, m->sorted + to, (from - to) * sizeof *m->sorted);
    }
    m->sorted[to] = x;
    m->sample[m->next] = x;
    m->next = m->next + 1 < WINDOW_OF ? m->next + 1 : 0;
    if (m->n < WINDOW_OF)
        m->n++;
}

void bigwindow_native_step(BigwindowNative *m, BigwindowSv *sv)
{
    if (m->first) {
        m->first = false;
        sv->state = 1;
    }
    put(m, sv->pressure);
    sv->middle = m->n % 2 != 0 ? m->sorted[m->n / 2] : (m->sorted[m->n / 2 - 1] + m->sorted[m->n / 2]) / 2;
    sv->low = m->sorted[0];
    sv->high = m->sorted[m->n - 1];
}
