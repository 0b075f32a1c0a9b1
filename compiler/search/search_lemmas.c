// SPDX-License-Identifier: Apache-2.0
// Relations between values of one step that exclude combinations of regions:
//
// 1. The samples of a window are between its smallest and its largest, and so are its median, its newest sample and, except for rounding, its
//    average.  The newest sample is the value of the window's argument in this step.
// 2. If all samples of a condition are true, or its run of true samples has any length, the condition is true in this step; if none is, it is false.
// 3. A variable to which each step in a state can add a limited amount is at most its value when the state began, plus that amount times the
//    number of steps in the state.
#include "compiler/search/search_regions.h"

// ---- windows ----

// Whether the value of a group is one statistic of a window.
static bool is_statistic(const Prover *p, const RegionGroup *g) { return g->y == SEARCH_NONE && p->value.at[g->x].op == IR_stat; }

static bool is_read_as(const Prover *p, uint32_t group, SmStat stat) { return p->value.at[p->group[group].x].stat == stat; }

// Returns the sample of a window, in the function that samples it; IR_NONE: none.
static IrRef sample_of(const Prover *p, uint32_t window)
{
    const IrFn *f = p->sample.fn;

    for (uint32_t i = 0; f && i < f->ins.n; i++)
        if (f->ins.at[i].op == IR_sample && f->ins.at[i].var == window)
            return f->ins.at[i].a;
    return IR_NONE;
}

// Returns the condition whose truth a sample is; IR_NONE: the sample is a number.  The event of a run is above 0 if its condition is true.
static IrRef condition_of(const Prover *p, IrRef sample, bool is_event)
{
    const IrIns *ins = p->sample.fn->ins.at;

    if (is_event && ins[sample].op == IR_add)
        sample = ins[sample].a;
    while (ins[sample].op == IR_cvt && ins[sample].type != SM_BOOL)
        sample = ins[sample].a;
    return ins[sample].type == SM_BOOL ? sample : IR_NONE;
}

static void add_lemma(Prover *p, RegionLemma l)
{
    if (p->lemmas < MOST_LEMMAS)
        p->lemma[p->lemmas++] = l;
}

// Adds what a statistic of a condition implies about the condition.
static void relate_condition(Prover *p, uint32_t group, IrRef condition)
{
    const RegionLemma above = {.kind = LEMMA_TRUE_ABOVE, .a = group, .condition = condition}, below = {.kind = LEMMA_FALSE_BELOW, .a = group, .condition = condition, .bound = 1};
    const SmStat stat = p->value.at[p->group[group].x].stat;
    RegionLemma all = above, none = below;

    all.bound = 0.99999999;                       // above the average of 0 and 1 if one of less than 100000 samples is 0
    none.bound = 1e-8;
    switch (stat) {
    case SM_STAT_MIN: case SM_STAT_RUN_TIME: add_lemma(p, above); break;
    case SM_STAT_MAX: add_lemma(p, below); break;
    case SM_STAT_NEWEST: case SM_STAT_RUN_STEPS:
        add_lemma(p, above);
        add_lemma(p, below);
        break;
    case SM_STAT_AVG:
        add_lemma(p, all);
        add_lemma(p, none);
        break;
    default: return;
    }
    p->group[group].least = 0;
    p->group[group].nan = false;
    if (!(SM_STATS_OF_RUNS >> stat & 1))
        p->group[group].most = 1;                 // each sample is 0 or 1
    region_add_condition(p, &p->sample, condition);
}

// Returns the index of the group that compares this value with constants; SEARCH_NONE if no condition does.
static uint32_t find_value(const Prover *p, uint32_t value)
{
    for (uint32_t i = 0; i < p->groups; i++)
        if (p->group[i].x == value && p->group[i].y == SEARCH_NONE)
            return i;
    return SEARCH_NONE;
}

// Adds that the first group is at most the second, if one of them is the smallest or the largest of the samples.
static void relate_order(Prover *p, uint32_t low, uint32_t high, bool is_average)
{
    const RegionLemma l = {.kind = LEMMA_ORDER, .a = low, .b = high, .tolerance = is_average ? 1e-9 : 0};

    if (low != high)
        add_lemma(p, l);
}

static bool is_middle(SmStat s) { return s == SM_STAT_AVG || s == SM_STAT_MEDIAN || s == SM_STAT_NEWEST || s == SM_STAT_OLDEST; }

// Relates two statistics of one window.
static void relate_statistics(Prover *p, uint32_t a, uint32_t b)
{
    const SmStat x = p->value.at[p->group[a].x].stat, y = p->value.at[p->group[b].x].stat;

    if (x == SM_STAT_MIN && (is_middle(y) || y == SM_STAT_MAX))
        relate_order(p, a, b, y == SM_STAT_AVG);
    if (y == SM_STAT_MAX && is_middle(x))
        relate_order(p, a, b, x == SM_STAT_AVG);
}

// Relates the smallest, largest and newest sample to the argument, if that is compared with constants too.
static void relate_argument(Prover *p, uint32_t group, IrRef sample)
{
    const uint32_t argument = find_value(p, p->sample.value_of[sample]);

    if (argument == SEARCH_NONE)
        return;
    if (is_read_as(p, group, SM_STAT_MIN) || is_read_as(p, group, SM_STAT_NEWEST))
        relate_order(p, group, argument, false);
    if (is_read_as(p, group, SM_STAT_MAX) || is_read_as(p, group, SM_STAT_NEWEST))
        relate_order(p, argument, group, false);
}

// Adds the lemmas that relate statistics of a window with the condition on its samples.
static void relate_windows(Prover *p)
{
    const uint32_t groups = p->groups;

    for (uint32_t i = 0; i < groups && p->fits; i++) {
        const Value v = p->value.at[p->group[i].x];
        IrRef sample, condition;
        if (!is_statistic(p, &p->group[i]) || (sample = sample_of(p, v.var)) == IR_NONE)
            continue;
        condition = condition_of(p, sample, (1u << v.stat & SM_STATS_OF_RUNS) != 0);
        if (condition != IR_NONE)
            relate_condition(p, i, condition);
        else
            relate_argument(p, i, sample);
        for (uint32_t other = 0; other < groups; other++)
            if (is_statistic(p, &p->group[other]) && p->value.at[p->group[other].x].var == v.var)
                relate_statistics(p, i, other);
    }
}

// ---- counts ----

// Returns how far the variable that value `value` loads can be from what it was when the function began, over all its loads with this value number.
static Drift drift_of_loads(const Prover *p, uint32_t value)
{
    const uint32_t var = p->value.at[value].var;
    const DriftPaths paths = drift_of_function(&p->k->work, p->own.fn, var);
    Drift d = {.any = false};

    for (uint32_t b = 0; b < p->own.fn->blk.n; b++)
        for (uint32_t n = 0; paths.reached[b] && n < p->own.fn->blk.at[b].ins.n; n++) {
            const IrRef ref = p->own.fn->blk.at[b].ins.at[n];
            if (p->own.fn->ins.at[ref].op == IR_load && p->own.value_of[ref] == value)
                d = drift_join(d, paths.of[ref]);
        }
    return d;
}

// Relates what the state counts to the time in the state.
static void relate_counts(Prover *p)
{
    const SearchFn *fn = &p->k->fn[p->fn];
    uint32_t time = SEARCH_NONE;

    for (uint32_t i = 0; i < p->groups; i++)
        if (p->group[i].y == SEARCH_NONE && p->value.at[p->group[i].x].op == IR_load && p->value.at[p->group[i].x].var == p->k->m->t)
            time = i;
    for (uint32_t i = 0; i < p->groups && time != SEARCH_NONE && p->facts && fn->is_step; i++) {
        const Value v = p->value.at[p->group[i].x];
        const DriftInState count = v.op == IR_load && p->group[i].y == SEARCH_NONE && i != time ? run_facts_drift(p->facts, fn->state, v.var) : (DriftInState){.has_high = false};
        const Drift d = count.has_high ? drift_of_loads(p, p->group[i].x) : (Drift){.any = true};
        if (!d.any && d.is_relative && !d.is_number)
            add_lemma(p, (RegionLemma){.kind = LEMMA_COUNT, .a = i, .b = time, .bound = count.bound[1] + d.by[1], .slope = count.each[1] / (double)(p->k->delta_t * p->k->every)});
    }
}

// ---- lemmas ----

void region_find_lemmas(Prover *p)
{
    relate_windows(p);
    relate_counts(p);
}

// Whether `low <= high`, which always holds of the two values, is possible in their current regions.
static bool is_order_possible(const RegionLemma *l, const RegionGroup *low, const RegionGroup *high)
{
    double a[2], b[2];
    bool in_a[2], in_b[2];
    double room;

    if (!region_bounds(low, a, in_a) || !region_bounds(high, b, in_b))
        return true;                              // a NaN excludes nothing: the window has stored it as 0
    room = l->tolerance * (a[0] < 0 ? -a[0] : a[0]);
    if (l->tolerance > 0 && !(room < 1e200))
        return true;
    return a[0] - room < b[1] || (a[0] - room == b[1] && ((in_a[0] && in_b[1]) || room > 0));
}

// Whether a lemma can be true in the current combination of regions.
static bool is_lemma_true(Prover *p, const RegionLemma *l)
{
    double a[2], b[2];
    bool in[2], in_b[2];

    switch (l->kind) {
    case LEMMA_ORDER: return is_order_possible(l, &p->group[l->a], &p->group[l->b]);
    case LEMMA_TRUE_ABOVE:
        return !region_bounds(&p->group[l->a], a, in) || a[0] < l->bound || (a[0] == l->bound && in[0]) || region_truth(p, &p->sample, l->condition);
    case LEMMA_FALSE_BELOW:
        return !region_bounds(&p->group[l->a], a, in) || a[1] > l->bound || (a[1] == l->bound && in[1]) || !region_truth(p, &p->sample, l->condition);
    case LEMMA_COUNT: break;
    }
    return !region_bounds(&p->group[l->a], a, in) || !region_bounds(&p->group[l->b], b, in_b) || a[0] <= l->bound + (l->slope > 0 ? l->slope * b[1] : 0);
}

bool region_is_consistent(Prover *p)
{
    for (uint32_t i = 0; i < p->lemmas; i++)
        if (!is_lemma_true(p, &p->lemma[i])) {
            p->counted |= p->lemma[i].kind == LEMMA_COUNT;
            return false;
        }
    return true;
}
