// SPDX-License-Identifier: Apache-2.0
// Reports states that are never left.
#include "compiler/analysis/analysis.h"

void analyse_missing_way_out(Analysis *a)
{
    bool *left = ARENA_ARRAY(a->arena, bool, a->p->state.n);      // by state: some transition to another state can be taken

    if (a->p->state.n == 1)
        return;                               // a machine with a single task that runs forever
    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (t->to != t->from && a->stmt[t->stmt->number].reached)
            left[t->from->number - 1] = true;
    }
    for (size_t i = 0; i < a->p->state.n; i++) {
        const State *s = a->p->state.at[i];
        Diag *d;
        if (left[i] || s->is_safe || !facts_may_reach(a->facts, i, BLOCK_ENTRY))
            continue;
        d = diag_report(a->diags, DIAG_no_way_out, s->span, s->name->text);
        diag_label(a->diags, d, DIAG_label_mark_safe, s->name->text);
    }
}
