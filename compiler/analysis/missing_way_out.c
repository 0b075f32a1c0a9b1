// SPDX-License-Identifier: Apache-2.0
// States that are never left.
#include "compiler/analysis/analysis.h"

// By state: whether some transition to another state can be taken.
static bool *find_left(const Analysis *a)
{
    bool *left = ARENA_ARRAY(a->arena, bool, a->p->state.n);

    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (t->to != t->from && a->stmt[t->stmt->number].reached)
            left[t->from->number - 1] = true;
    }
    return left;
}

// ---- states without an exit ----

static void report_no_way_out(Analysis *a, const State *s)
{
    Diag *d = diag_report(a->diags, DIAG_no_way_out, s->span, s->name->text);

    diag_label(a->diags, d, DIAG_label_mark_safe, s->name->text);
}

void analyse_missing_way_out(Analysis *a)
{
    const bool *left;

    if (a->p->state.n == 1)
        return;                               // a machine with a single task that runs forever
    left = find_left(a);
    for (size_t s = 0; s < a->p->state.n; s++)
        if (!left[s] && !a->p->state.at[s]->is_safe && facts_may_reach(a->facts, s, BLOCK_ENTRY))
            report_no_way_out(a, a->p->state.at[s]);
}
