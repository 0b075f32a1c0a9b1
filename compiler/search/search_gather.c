// SPDX-License-Identifier: Apache-2.0
// Fewer times at which a scenario changes inputs: a change is made together with an earlier one, where that still reaches the goals.  The number of
// changes stays.  A reader follows one line that sets three inputs more easily than three lines at different times.
//
// A beginning of a gathered scenario has changes that only later states need.  So scenarios are gathered last, when no path to a state is taken from
// them any more.
#include <string.h>

#include "compiler/search/search_choose.h"

// Returns the index of the first change that is made in the same step as change i.
static size_t first_of_time(const Scenario *s, size_t i)
{
    while (i > 0 && s->change[i - 1].step == s->change[i].step)
        i--;
    return i;
}

// Moves change i of an attempt to the step of the earlier change `to`.  A ramp would have other values if it began earlier.
static bool edit_gather(Attempt *t, size_t i, size_t to)
{
    ScenarioChange x = t->change[i];
    const SearchAnchor anchor = t->anchor[to];

    x.step = t->change[to].step;
    if (x.kind == SCENARIO_RAMP || scenario_loop_at(&t->s, x.step) || scenario_loop_at(&t->s, t->change[i].step))
        return false;
    for (size_t j = first_of_time(&t->s, to); j < i; j++)
        if (t->change[j].var == x.var)
            return false;
    memmove(t->change + to + 2, t->change + to + 1, (i - to - 1) * sizeof *t->change);
    memmove(t->anchor + to + 2, t->anchor + to + 1, (i - to - 1) * sizeof *t->anchor);
    t->change[to + 1] = x;
    t->anchor[to + 1] = anchor;
    return true;
}

// Moves change i to the nearest earlier time at which the goals are still reached.  Returns false if no time is such a one.
static bool gather_change(Reducer *r, size_t i)
{
    for (size_t to = first_of_time(r->s, i); to > 0 && chooser_has_effort(r->c); to = first_of_time(r->s, to - 1))
        if (chooser_try_edit(r, edit_gather, i, to - 1))
            return true;
    return false;
}

// Moves all changes of one time to earlier ones.  If one cannot be moved, the others stay, too: they are then nearest to what they are for.
static bool gather_time(Reducer *r, size_t first, size_t n)
{
    const Scenario was = *r->s;
    SearchEnter *enter = r->enter;
    const uint32_t enters = r->enters, end = r->c->end;

    for (size_t i = first; i < first + n; i++)
        if (!gather_change(r, i) || r->s->changes != was.changes) {
            if (r->s->changes == was.changes) {
                *r->s = was;
                r->enter = enter;
                r->enters = enters;
                r->c->end = end;
            }
            return false;
        }
    return true;
}

void chooser_gather(Chooser *c, Scenario *s, const GoalSet *want)
{
    Reducer r = {.c = c, .s = s, .want = want};

    if (!chooser_begin_reducer(&r))
        return;
    for (size_t i = s->changes; i-- > 0 && i < s->changes && chooser_has_effort(c); ) {
        const size_t first = first_of_time(s, i);
        gather_time(&r, first, i - first + 1);
        i = first < s->changes ? first : s->changes;
    }
}
