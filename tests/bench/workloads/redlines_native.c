// SPDX-License-Identifier: Apache-2.0
// The red lines as an expert writes them: the last samples of all sensors are adjacent.  A loop without branches finds whether any limit is
// violated, and only then a second loop finds which one.
#include <string.h>

#include "tests/bench/workloads/redlines.h"

enum { RUN = 1, TRIPPED };

static const float least[SENSORS] = {-20, -21, -22, -23, -24, -25, -26, -27, -28, -29, -30, -31, -32, -33, -34, -35, -36, -37, -38, -39, -40, -41, -42, -43};
static const float most[SENSORS] = {60, 63, 66, 69, 72, 75, 61, 64, 67, 70, 73, 76, 62, 65, 68, 71, 74, 60, 63, 66, 69, 72, 75, 61};

void redlines_native_init(RedlinesNative *m, RedlinesSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = RUN;
    m->first = true;
    sv->state = RUN;
}

static inline float less(float x, float y) { return x < y ? x : y; }
static inline float more(float x, float y) { return x > y ? x : y; }

// Stores a sample.  The median of two samples is computed as that of three, of which one is the mean of the others.
static void put(RedlinesNative *m, const RedlinesSv *sv)
{
    memcpy(m->sample[m->n % 4], &sv->s0, sizeof *m->sample);          // the elements are adjacent
    if (m->n == 0)
        memcpy(m->sample[3], m->sample[0], sizeof *m->sample);
    if (m->n == 1)
        for (int i = 0; i < SENSORS; i++)
            m->sample[3][i] = (m->sample[0][i] + m->sample[1][i]) / 2;
    m->n++;
}

static inline float median(const float *a, const float *b, const float *c, int i)
{
    return more(less(a[i], b[i]), less(more(a[i], b[i]), c[i]));
}

static float average(const RedlinesNative *m, int i)
{
    float sum = 0;

    for (uint32_t k = 0; k < 4 && k < m->n; k++)
        sum += m->sample[(m->n - 1 - k) % 4][i];
    return sum / (float)(m->n < 4 ? m->n : 4);
}

static int violated(const RedlinesNative *m)                        // returns the number of the first sensor beyond its limit; 0: none
{
    const float *a = m->sample[(m->n - 1) % 4], *b = m->sample[(m->n - 2) % 4], *c = m->sample[m->n < 3 ? 3 : (m->n - 3) % 4];
    int any = 0;

    if (m->n == 1)
        b = a;
    for (int i = 0; i < SENSORS; i++) {
        const float x = median(a, b, c, i);
        any |= !(least[i] < x) | !(x < most[i]);
    }
    for (int i = 0; any && i < SENSORS; i++) {
        const float x = median(a, b, c, i);
        if (!(least[i] < x && x < most[i]))
            return i + 1;
    }
    return 0;
}

static void go_to(RedlinesNative *m, uint32_t to)
{
    m->state = to;
    m->first = true;
}

void redlines_native_step(RedlinesNative *m, RedlinesSv *sv)
{
    const bool first = m->first;

    if (first) {
        m->first = false;
        m->start = sv->time;
        sv->state = m->state;
    }
    put(m, sv);
    if (m->state == RUN) {
        int code;

        if (first)
            sv->closed = false;
        sv->hottest = more(more(average(m, 0), average(m, 1)), more(average(m, 2), average(m, 3)));
        code = violated(m);
        if (code != 0) {
            sv->code = (uint8_t)code;
            go_to(m, TRIPPED);
        }
        return;
    }
    if (first) {
        sv->closed = true;
        if (sv->trips < UINT16_MAX)
            sv->trips++;
    }
    if (sv->reset && sv->time - m->start > 30)
        go_to(m, RUN);
}
