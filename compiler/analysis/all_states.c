// SPDX-License-Identifier: Apache-2.0
// Findings on statements of [all_states]. The analyses see a copy of the statements in each state. Code that is useless in one state can be
// needed in another, so such a finding is reported only if it is true in all states that the machine reaches. Other findings name the states
// in which they are true, unless these are all.
#include "compiler/analysis/analysis.h"

// Whether finding d says that a part of the code has no effect.
static bool is_about_code(const Diag *d)
{
    const char *name = diag_info[d->code].flag;

    return name && diag_find_flag(name)->copies == DIAG_COPIES_CODE;
}

// Returns the number of reachable states in which the section [all_states] that contains the source position `at` runs.
static size_t count_states_at(const Analysis *a, uint32_t at)
{
    size_t n = 0;

    for (size_t i = 0; i < a->p->all_states.n; i++) {
        const AllStates *all = a->p->all_states.at[i];
        for (size_t s = 0; at - all->span.at < all->span.len && s < a->p->state.n; s++)
            n += !all->excepted[s + 1] && facts_may_reach(a->facts, s, BLOCK_STEP);
    }
    return n;
}

// Returns the names of the states in which d is true: "'Run', 'Hold' and 'Vent'".
static const char *list_states(const Analysis *a, const Diag *d)
{
    const char *list = "";

    for (size_t i = 0; i < d->states.n; i++)
        list = format_in(a->arena, "%s%s'%s'", list, i == 0 ? "" : i + 1 < d->states.n ? ", " : " and ", d->states.at[i]);
    return list;
}

// Completes the findings from list.at[first] on that are about statements of [all_states].
void complete_all_states_findings(Analysis *a, size_t first)
{
    for (size_t i = a->diags->list.n; i-- > first; ) {
        Diag *d = a->diags->list.at[i];
        const size_t states = d->states.n ? count_states_at(a, d->span.at) : 0;

        if (d->states.n >= states)
            continue;
        if (is_about_code(d))
            diags_remove_warning(a->diags, i);
        else
            diag_note(a->diags, d, (Span){0}, DIAG_note_in_states, list_states(a, d));
    }
}
