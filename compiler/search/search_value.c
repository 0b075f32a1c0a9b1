// SPDX-License-Identifier: Apache-2.0
// Chooses values within bounds: values that a person would write, values that the machine compares with, and any other.
#include "compiler/search/search_wish.h"

static const double power[] = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
                               1e12};
enum { POWERS = sizeof power / sizeof *power };

static double nearest_whole(double x) { return x < -9e15 || x > 9e15 ? x : (double)(int64_t)(x + (x < 0 ? -0.5 : 0.5)); }

bool search_is_within(const SearchWish *w, double x)
{
    return (w->above ? x > w->lo : x >= w->lo) && (w->below ? x < w->hi : x <= w->hi) && !(w->differs && x == w->other);
}

// Rounds x to the coarsest decimal step that stays within the bounds and changes it by at most `most`.
static double round_within(const SearchWish *w, double x, double most)
{
    for (int i = POWERS; i-- > 0; ) {
        const double unit = power[i], y = i >= 9 ? nearest_whole(x / unit) * unit : nearest_whole(x * power[18 - i]) / power[18 - i];
        if (y - x <= most && x - y <= most && search_is_within(w, y))
            return y;
    }
    return x;
}

double search_unit_of(const SearchInput *in, double x)
{
    const double size = x < 0 ? -x : x;
    int i = 8;

    if (!ir_is_float(in->type))
        return 1;
    if (size > 0 && size < 1)
        for (i = 0; i < 8 && power[i + 1] < size / 50; i++) { }
    return size >= 1 ? size >= 20 ? 1 : 0.1 : size == 0 ? 0.1 : power[i];
}

// Narrows the bounds to the range of the input, if some value is within both.
static void clamp_to_range(const SearchInput *in, SearchWish *w)
{
    const Range *r = in->range;

    if (!r || (w->below ? r->lo >= w->hi : r->lo > w->hi) || (w->above ? r->hi <= w->lo : r->hi < w->lo))
        return;
    if (r->lo > w->lo) {
        w->lo = r->lo;
        w->above = false;
    }
    if (r->hi < w->hi) {
        w->hi = r->hi;
        w->below = false;
    }
}

// Bounds that exclude each other come from conditions that need different values one after the other.  Keeps one of them.
static void keep_one_bound(SearchRun *k, const SearchInput *in, SearchWish *w)
{
    const bool keeps_low = search_chance(k, 50);

    *(keeps_low ? &w->hi : &w->lo) = keeps_low ? SEARCH_BIG : -SEARCH_BIG;
    *(keeps_low ? &w->below : &w->above) = false;
    clamp_to_range(in, w);
}

double search_choose_value(SearchRun *k, uint32_t input)
{
    const SearchInput *in = &k->input[input];
    SearchWish w = k->wish[input];
    double x, span, unit;

    if (in->type == SM_BOOL)
        return w.differs ? w.other == 0 : w.lo > 0 || (w.lo == 0 && w.above) ? 1 : w.hi < 1 || (w.hi == 1 && w.below) ? 0 : search_pick(k, 2);
    if (search_chance(k, 90))
        clamp_to_range(in, &w);
    if (w.lo > w.hi || (w.lo == w.hi && (w.above || w.below)))
        keep_one_bound(k, in, &w);
    if (w.lo == w.hi)
        return w.lo;
    if (in->constant.n && search_chance(k, 25)) {
        x = in->constant.at[search_pick(k, in->constant.n)];
        if (search_is_within(&w, x))
            return x;
    }
    if (w.lo < -SEARCH_BIG / 2 && w.hi > SEARCH_BIG / 2) {
        const double base = w.differs ? w.other : in->constant.at[search_pick(k, in->constant.n)];
        return base + search_unit_of(in, base) * ((double)search_pick(k, 21) - 10 + w.differs * 11);
    }
    if (w.lo < -SEARCH_BIG / 2 || w.hi > SEARCH_BIG / 2) {
        const double bound = w.lo < -SEARCH_BIG / 2 ? w.hi : w.lo, size = bound < 0 ? -bound : bound, sign = w.lo < -SEARCH_BIG / 2 ? -1 : 1;
        unit = search_unit_of(in, bound);
        span = search_chance(k, 50) ? unit : search_chance(k, 60) ? unit + size / 10 : unit + size * (1 + search_pick(k, 4));
        x = bound + sign * span;
        return round_within(&w, x, span / 2);
    }
    span = w.hi - w.lo;
    unit = search_unit_of(in, span / 2);
    switch (search_pick(k, 4)) {
    case 0: x = w.lo + (unit < span / 2 ? unit : span / 4); break;
    case 1: x = w.hi - (unit < span / 2 ? unit : span / 4); break;
    case 2: x = w.lo + span / 2; break;
    default: x = w.lo + span * search_pick(k, 1001) / 1000; break;
    }
    x = search_is_within(&w, x) ? x : w.lo + span / 2;
    return round_within(&w, x, span / 8);
}
