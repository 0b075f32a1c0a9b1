// SPDX-License-Identifier: Apache-2.0
// Rolling windows of samples in the reference (language.md 7).  They store the samples, and each access computes its statistic from
// all of them.
#include "compiler/script/ref.h"

#include <float.h>
#include <string.h>

static bool has_times(const Window *what) { return 1u << what->stat & SM_STATS_OF_TIMES; }

uint32_t ref_window_samples(const Window *what) { return 1u << what->stat & SM_STATS_OF_RUNS ? 1 : what->size; }

void ref_window_place(RefWindow *w, void *samples)
{
    w->slot = has_times(w->what) ? NULL : samples;
    w->time = has_times(w->what) ? samples : NULL;
}

void ref_windows_init_unplaced(RefWindows *w, Arena *arena, const Windows *list)
{
    uint32_t longest = 0;

    w->n = list->n;
    w->at = ARENA_ARRAY(arena, RefWindow, list->n);
    for (size_t i = 0; i < list->n; i++) {
        w->at[i].what = &list->at[i];
        if (longest < list->at[i].size)
            longest = list->at[i].size;
    }
    w->scratch = ARENA_ARRAY(arena, double, longest);
}

void ref_windows_init(RefWindows *w, Arena *arena, const Windows *list)
{
    ref_windows_init_unplaced(w, arena, list);
    for (size_t i = 0; i < list->n; i++)
        ref_window_place(&w->at[i], ARENA_ARRAY(arena, uint64_t, ref_window_samples(&list->at[i])));
}

void ref_windows_clear(RefWindows *w)
{
    for (size_t i = 0; i < w->n; i++)
        w->at[i].next = w->at[i].filled = 0, w->at[i].ran = false;
}

// Adds a sample to a run of true samples: r->filled is their number, at most the size.
static void extend_run(RefWindow *r, bool is_true, uint64_t g)
{
    const bool gap = r->what->gap && r->ran && g - r->last > r->what->gap;

    if (!is_true || gap)
        r->filled = 0;
    if (is_true && r->filled == 0)
        r->time[0] = g;
    if (is_true && r->filled < r->what->size)
        r->filled++;
    r->last = g;
    r->ran = true;
}

// Stores a sample in every window, in index order.
void ref_windows_sample(RefWindows *w, const uint64_t *cell)
{
    for (size_t i = 0; i < w->n; i++) {
        RefWindow *r = &w->at[i];
        double x;

        if (r->is_unused)
            continue;
        x = ref_eval(r->what->sample, cell, w);
        if (1u << r->what->stat & SM_STATS_OF_RUNS) {
            extend_run(r, ref_true(x), cell[r->what->time->index]);
            continue;
        }
        if (r->time)
            r->time[r->next] = cell[r->what->time->index];
        else
            r->slot[r->next] = x != x ? 0 : x;        // NaN is stored as 0
        r->next = r->next + 1 == r->what->size ? 0 : r->next + 1;
        if (r->filled < r->what->size)
            r->filled++;
    }
}

static bool sorts_before(double a, double b)          // whether a comes before b in ascending order, in which -0 is below +0
{
    return a < b || (a == b && ref_negative(a) && !ref_negative(b));
}

static void sort_samples(double *x, size_t n)                 // shellsort: insertion sort over decreasing distances
{
    size_t gap = 1;

    while (gap < n / 3)
        gap = gap * 3 + 1;
    for (; gap > 0; gap /= 3)
        for (size_t i = gap; i < n; i++) {
            double moved = x[i];
            size_t j = i;
            for (; j >= gap && sorts_before(moved, x[j - gap]); j -= gap)
                x[j] = x[j - gap];
            x[j] = moved;
        }
}

// Returns the average by pairwise summation: replaces the samples by the sums of their pairs, repeatedly, until one is left.  An odd
// last one is copied.
double ref_average(double *x, uint32_t n)
{
    uint32_t left = n;

    while (left > 1) {
        uint32_t sums = 0;
        for (uint32_t i = 0; i < left; i += 2)
            x[sums++] = i + 1 < left ? x[i] + x[i + 1] : x[i];
        left = sums;
    }
    return x[0] / (double)n;
}

double ref_median(double *x, uint32_t n)
{
    double a, b, distance;

    sort_samples(x, n);
    if (n % 2 == 1)
        return x[n / 2];
    a = x[n / 2 - 1];
    b = x[n / 2];
    distance = b - a;
    if (a == b)
        return a;
    if (distance > DBL_MAX || distance != distance)   // not finite
        return a / 2 + b / 2;
    return a + distance / 2;
}

static double find_extreme(const double *x, uint32_t n, bool largest)
{
    double best = x[0];

    for (uint32_t i = 1; i < n; i++)
        if (largest ? sorts_before(best, x[i]) : sorts_before(x[i], best))
            best = x[i];
    return best;
}

// Returns the difference between the largest and the smallest sample.
static double range_of(const double *x, uint32_t n)
{
    double low = find_extreme(x, n, false), high = find_extreme(x, n, true);

    return low == high ? 0 : high - low;
}

double ref_statistic(const RefWindows *w, uint32_t window, SmStat stat)
{
    const RefWindow *r = &w->at[window];
    const uint32_t oldest = r->filled < r->what->size ? 0 : r->next, newest = (r->next == 0 ? r->what->size : r->next) - 1;
    double *x = w->scratch;

    if (r->filled == 0)
        return 0;                                     // only the run of `held` can be read without samples, after it has ended; its length is then 0
    if (r->slot)
        memcpy(x, r->slot, r->filled * sizeof *x);
    switch (stat) {
    case SM_STAT_AVG: return ref_average(x, r->filled);
    case SM_STAT_MEDIAN: return ref_median(x, r->filled);
    case SM_STAT_MIN: return find_extreme(x, r->filled, false);
    case SM_STAT_MAX: return find_extreme(x, r->filled, true);
    case SM_STAT_RANGE: return range_of(x, r->filled);
    case SM_STAT_OLDEST: return r->slot[oldest];
    case SM_STAT_CHANGE: return r->filled < 2 ? 0 : r->slot[newest] - r->slot[oldest];
    case SM_STAT_ELAPSED: return ref_read(SM_U64, r->time[newest] - r->time[oldest]);
    case SM_STAT_RUN_STEPS: return r->filled;
    case SM_STAT_RUN_TIME: return ref_read(SM_U64, r->last - r->time[0]);
    case SM_STAT_NEWEST: return r->slot[newest];
    case SM_STAT_COUNT: break;
    }
    return 0;
}
