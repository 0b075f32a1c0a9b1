// SPDX-License-Identifier: Apache-2.0
// Short runs with values that sensors have when they fail: infinities, the ends of ranges, values beyond them, and numbers of the machine.
//
// Faults of the first steps of a state need several inputs in one step, or an input for one step only: windows that are not full, a NaN from
// two infinities in a window, a command that is taken back.  The distances to a goal do not lead there, and long runs rarely have them.  So
// runs of a few steps are made in which any inputs change in each step.  Each costs a few steps.
#include "compiler/search/search_run.h"

enum {
    RUN_STEPS = 8,            // the most changes of a run, one after another
    MOST_FIRST = 6,           // the most inputs that the first change of a run sets together
    MOST_LATER = 2,           // the most inputs that a later change sets together
    SETTLE_PERCENT = 10       // after so many of a hundred changes, the machine runs for more than one step
};

static double value_beyond(const SearchInput *in, bool above)
{
    const double size = in->range ? in->range->hi - in->range->lo : 1e30;

    return !in->range ? above ? size : -size : above ? in->range->hi + size : in->range->lo - size;
}

// Chooses an infinity, an end of the input's range or a value beyond it, a number with which the machine compares the input, or one next to it.
static double choose_special_value(SearchRun *k, const SearchInput *in)
{
    const bool above = search_chance(k, 50);
    const double base = in->constant.at[search_pick(k, in->constant.n)];
    double x;

    if (in->type == SM_BOOL)
        return search_pick(k, 2);
    switch (search_pick(k, 8)) {
    case 0: case 1: x = above ? 1e308 * 10 : -1e308 * 10; break;
    case 2: x = value_beyond(in, above); break;
    case 3: x = in->range ? above ? in->range->hi : in->range->lo : base; break;
    case 4: x = base + (above ? 1 : -1); break;
    default: x = base; break;
    }
    if (in->range && k->o->specials == SEARCH_SPECIALS_IN_RANGES)
        x = x < in->range->lo ? in->range->lo : x > in->range->hi ? in->range->hi : x;
    return x;
}

static void change_inputs(SearchRun *k, uint32_t most)
{
    const uint32_t n = search_pick(k, (k->inputs < most ? k->inputs : most) + 1);

    k->turn.n = 0;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t input = search_pick(k, k->inputs);
        const ScenarioChange c = {.var = k->input[input].var, .kind = SCENARIO_HOLD, .a = choose_special_value(k, &k->input[input])};
        search_add_change(k, &c);
    }
}

static uint64_t choose_length(SearchRun *k)
{
    if (!search_chance(k, SETTLE_PERCENT))
        return 1;
    return search_chance(k, 50) ? k->longest + 1 : 2 + search_pick(k, RUN_STEPS);
}

void search_run_specials(SearchRun *k, uint32_t node)
{
    const uint32_t changes = 1 + search_pick(k, RUN_STEPS);

    k->node.at[node].users++;
    for (uint32_t i = 0; i < changes && k->open && search_goes_on(k) && k->node.at[node].copy; i++) {
        uint32_t next;
        change_inputs(k, i == 0 ? MOST_FIRST : MOST_LATER);
        next = search_run_segment(k, node, k->turn.at, k->turn.n, choose_length(k), SEARCH_NONE);
        search_drop(k, node);
        node = next;
    }
    search_drop(k, node);
}
