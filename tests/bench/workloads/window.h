// SPDX-License-Identifier: Apache-2.0
// Windows as the language defines them (language.md 7), of doubles, without optimisation: each access computes its statistic again.
#ifndef BENCH_WINDOW_H
#define BENCH_WINDOW_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "stdlib/f64.h"

typedef struct Window { double *slot; uint32_t size, n, next; } Window;
enum { MOST_SLOTS = 50 };

static inline void window_init(Window *w, double *slot, uint32_t size)
{
    w->slot = slot;
    w->size = size;
    w->n = w->next = 0;
}

static inline void window_put(Window *w, double x)
{
    w->slot[w->next] = x;
    w->next = w->next + 1 < w->size ? w->next + 1 : 0;
    if (w->n < w->size)
        w->n++;
}

static inline bool comes_before(double x, double y)           // -0 precedes +0
{
    return x < y || (x == y && sm_bits(x) > sm_bits(y));
}

// Returns the average by pairwise summation: sums of pairs, then sums of these sums, and so on.
static inline double window_avg(const Window *w)
{
    double sum[MOST_SLOTS];
    uint32_t n = w->n;

    memcpy(sum, w->slot, n * sizeof *sum);
    for (; n > 1; n = (n + 1) / 2)
        for (uint32_t i = 0; i < n; i += 2)
            sum[i / 2] = i + 1 < n ? sum[i] + sum[i + 1] : sum[i];
    return sum[0] / (double)w->n;
}

static inline double middle(double a, double b)
{
    const double d = b - a;

    if (a == b)
        return a;
    return d < HUGE_VAL ? a + d / 2 : a / 2 + b / 2;
}

static inline double window_median(const Window *w)
{
    double sorted[MOST_SLOTS];

    for (uint32_t i = 0; i < w->n; i++) {
        const double x = w->slot[i];
        uint32_t k = i;
        for (; k > 0 && comes_before(x, sorted[k - 1]); k--)
            sorted[k] = sorted[k - 1];
        sorted[k] = x;
    }
    return middle(sorted[(w->n - 1) / 2], sorted[w->n / 2]);
}

static inline double window_min(const Window *w)
{
    double x = w->slot[0];

    for (uint32_t i = 1; i < w->n; i++)
        if (comes_before(w->slot[i], x))
            x = w->slot[i];
    return x;
}

static inline double window_max(const Window *w)
{
    double x = w->slot[0];

    for (uint32_t i = 1; i < w->n; i++)
        if (comes_before(x, w->slot[i]))
            x = w->slot[i];
    return x;
}

static inline double window_range(const Window *w)
{
    const double least = window_min(w), most = window_max(w);

    return least == most ? 0.0 : most - least;
}

#endif
