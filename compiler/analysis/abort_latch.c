// SPDX-License-Identifier: Apache-2.0
// States that abort as soon as they are entered again, because a variable set before the last abort is still set.
//
// Compares two situations at the entry of a state, with full rolling windows and the same healthy readings.  If the first aborts within two
// steps for all readings for which the second does not, the reason is a variable that differs between them and that the guard of
// the transition reads.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"

enum {
    DRAWS_MAX = 40,               // how many random inputs are tried for two situations
    STEPS_AT_ONCE = 2             // an abort within this many steps after the entry counts as immediate
};

typedef struct LatchSearch {
    Trials *t;
    AbortBound bound;             // the states that always lead to an @abort state
    void *at;                     // the current situation of a run
    double *in;                   // the inputs of the run
} LatchSearch;

// Runs STEPS_AT_ONCE steps from the situation of e with the current inputs.  Returns the first transition taken if it leads to an
// @abort state, or to a state that always leads there; NULL if it leads elsewhere, or if none is taken.
static const Transition *find_early_abort(LatchSearch *l, const TrialEntry *e)
{
    Trials *t = l->t;

    trial_copy_situation(t, l->at, e->situation);
    trial_fill_windows(t, l->at, l->in);
    for (int k = 0; k < STEPS_AT_ONCE; k++) {
        const Transition *taken;
        trial_step(t, l->at, l->in, t->dt, &t->trace);
        taken = t->trace.transition ? t->transition[t->trace.transition] : NULL;
        if (taken)
            return l->bound.bound[taken->to->number - 1] ? taken : NULL;
    }
    return NULL;
}

// Returns the transition by which a run from e aborts for all tried inputs for which a run from `other` does not.  NULL: these runs from
// e do not all abort, or by different transitions, or every run from `other` aborts.
static const Transition *find_abort_of_one_only(LatchSearch *l, const TrialEntry *e, const TrialEntry *other)
{
    Trials *t = l->t;
    const Transition *taken = NULL;

    for (int n = 0; n < DRAWS_MAX; n++) {
        const Transition *now;
        memcpy(l->in, e->in, t->inputs * sizeof *l->in);
        for (uint32_t i = 0; i < t->inputs; i++)
            if (t->input[i].command && n % 2)
                l->in[i] = other->in[i];
        trial_draw_inputs(t, l->in, NULL, false, false);
        if (find_early_abort(l, other))
            continue;
        now = find_early_abort(l, e);
        if (!now || (taken && taken != now))
            return NULL;
        taken = now;
    }
    return taken;
}

// Compares two situations at the entry of a state.  Reports a variable whose value makes runs from e abort, but not runs from `other`.
// Returns whether one was reported.
static bool try_report_latch(LatchSearch *l, const State *state, const TrialEntry *e, const TrialEntry *other)
{
    const Analysis *a = l->t->a;
    const Transition *taken = find_abort_of_one_only(l, e, other);
    const Var *latch = taken ? trial_find_difference(l->t, taken->when, e->situation, other->situation) : NULL;

    if (latch)
        diag_report(a->diags, DIAG_abort_latch, taken->stmt->span, state->name->text, latch->name->text,
                    const_text(a->arena, trial_vars(l->t, e->situation)[a->m->var_of[latch->index]]));
    return latch != NULL;
}

// Finds states that abort at once when they are entered again, because a variable that was set before an earlier abort is still set.
void check_abort_latch(Trials *t)
{
    LatchSearch l = {t, abort_find_bound(t->a), arena_alloc(t->a->arena, t->run->size), trial_new_inputs(t)};

    for (size_t s = 0; s < t->a->p->state.n; s++) {
        const TrialState *entries = &t->state[s];
        bool found = l.bound.bound[s];
        for (size_t n = 0; n < entries->entry.n && !found; n++)
            for (size_t k = 0; k < entries->entry.n && !found; k++)
                found = k != n && try_report_latch(&l, t->a->p->state.at[s], &entries->entry.at[n], &entries->entry.at[k]);
    }
}
