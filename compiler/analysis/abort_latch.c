// SPDX-License-Identifier: Apache-2.0
// States that abort as soon as they are entered again, because a variable set before the last abort is still set.
//
// Compares two situations at the entry of a state, with full windows and the same healthy readings.  One goes to an @abort
// state within two steps for all readings for which the other does not.  A variable that the transition reads and that differs
// between the two is the reason.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"

enum { DRAWS = 40, AT_ONCE = 2 };

typedef struct Latch {
    Trials *t;
    AbortBound bound;
    void *at;
    double *in;
} Latch;

// The transition to an abort that it takes within two steps; NULL: it takes another transition or none.
static const Transition *aborts_at_once(Latch *l, const TrialEntry *e)
{
    Trials *t = l->t;

    trial_copy(t, l->at, e->situation);
    trial_fill_windows(t, l->at, l->in);
    for (int k = 0; k < AT_ONCE; k++) {
        const Transition *made;
        trial_step(t, l->at, l->in, t->dt, &t->trace);
        made = t->trace.transition ? t->transition[t->trace.transition] : NULL;
        if (made)
            return l->bound.bound[made->to->number - 1] ? made : NULL;
    }
    return NULL;
}

// The transition that e always takes when `other` does not abort.  NULL: e does not always take it, or `other` always aborts.
static const Transition *aborts_where_not(Latch *l, const TrialEntry *e, const TrialEntry *other)
{
    Trials *t = l->t;
    const Transition *made = NULL;

    for (int n = 0; n < DRAWS; n++) {
        const Transition *now;
        memcpy(l->in, e->in, t->inputs * sizeof *l->in);
        for (uint32_t i = 0; i < t->inputs; i++)
            if (t->input[i].command && n % 2)
                l->in[i] = other->in[i];
        trial_draw(t, l->in, NULL, false, false);
        if (aborts_at_once(l, other))
            continue;
        now = aborts_at_once(l, e);
        if (!now || (made && made != now))
            return NULL;
        made = now;
    }
    return made;
}

static bool look_at_pair(Latch *l, const State *state, const TrialEntry *e, const TrialEntry *other)
{
    const Analysis *a = l->t->a;
    const Transition *made = aborts_where_not(l, e, other);
    const Var *latch = made ? trial_differing(l->t, made->when, e->situation, other->situation) : NULL;

    if (latch)
        diag_report(a->diags, DIAG_abort_latch, made->stmt->span, state->name->text, latch->name->text,
                    const_text(a->arena, trial_vars(l->t, e->situation)[a->m->var_of[latch->index]]));
    return latch != NULL;
}

static void look_at_state(Latch *l, const TrialState *s, const State *state)
{
    bool found = false;

    for (size_t n = 0; n < s->entry.n && !found; n++)
        for (size_t k = 0; k < s->entry.n && !found; k++)
            found = k != n && look_at_pair(l, state, &s->entry.at[n], &s->entry.at[k]);
}

void question_abort_latch(Trials *t)
{
    Latch l = {t, abort_bound(t->a), arena_alloc(t->a->arena, t->run->size), trial_new_inputs(t)};

    for (size_t s = 0; s < t->a->p->state.n; s++)
        if (!l.bound.bound[s])
            look_at_state(&l, &t->state[s], t->a->p->state.at[s]);
}
