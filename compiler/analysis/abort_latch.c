// SPDX-License-Identifier: Apache-2.0
// States that abort at once when they begin again, because what was set on the way to the last abort is still set.
//
// Of two situations at the beginning of a state, one goes to an @abort state within two steps whatever healthy sensors read, windows
// full of that; the other does not.  A variable that the transition reads and that differs between the two is the reason.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/questions.h"

enum { DRAWS = 12, AT_ONCE = 2 };

typedef struct Latch {
    Trials *t;
    AbortBound bound;
    void *at;
    double *in;
} Latch;

static void healthy_inputs(void *context, double *vars, uint32_t sample)
{
    const Latch *l = context;

    (void)sample;
    for (uint32_t i = 0; i < l->t->inputs; i++)
        vars[l->t->input[i].var] = ir_run_number(l->t->input[i].v->type, l->in[i]);
}

// The transition that it makes to an abort within two steps whatever sensors read; NULL: it does not always.
static const Transition *aborts_at_once(Latch *l, const TrialEntry *e)
{
    Trials *t = l->t;
    const Transition *made = NULL;

    for (int n = 0; n < DRAWS; n++) {
        const Transition *now = NULL;
        memcpy(l->in, e->in, t->inputs * sizeof *l->in);
        trial_draw(t, l->in, NULL, false, false);
        trial_copy(t, l->at, e->situation);
        ir_run_fill(t->run, l->at, t->window, healthy_inputs, l);
        for (int k = 0; k < AT_ONCE && !now; k++) {
            trial_step(t, l->at, l->in, t->dt, &t->trace);
            now = t->trace.transition ? t->transition[t->trace.transition] : NULL;
        }
        if (!now || !l->bound.bound[now->to->number - 1] || (made && made != now))
            return NULL;
        made = now;
    }
    return made;
}

typedef struct Differs { const Latch *l; const double *again, *first; const Var *found; } Differs;

static void look_at_var(Expr *e, void *context)
{
    Differs *d = context;
    const uint32_t v = e->kind == EX_VAR ? d->l->t->a->m->var_of[e->var->index] : IR_NONE;

    if (v != IR_NONE && e->var->written && !d->found && d->again[v] != d->first[v])
        d->found = e->var;
}

static void look_at_state(Latch *l, TrialState *s, const State *state)
{
    const Analysis *a = l->t->a;
    const TrialEntry *first = NULL;

    for (size_t n = 0; n < s->entry.n && !first; n++)
        if (!aborts_at_once(l, &s->entry.at[n]))
            first = &s->entry.at[n];
    for (size_t n = 0; n < s->entry.n && first; n++) {
        const TrialEntry *e = &s->entry.at[n];
        const Transition *made = aborts_at_once(l, e);
        Differs d = {l, ir_run_vars(l->t->run, e->situation), ir_run_vars(l->t->run, first->situation), NULL};
        for (const Condition *c = made ? made->when : NULL; c; c = c->outer)
            expr_walk(c->stmt->value, look_at_var, &d);
        if (!d.found)
            continue;
        diag_report(a->diags, DIAG_abort_latch, made->stmt->span, state->name->text, d.found->name->text,
                    const_text(a->arena, d.again[a->m->var_of[d.found->index]]));
        return;
    }
}

void question_abort_latch(Trials *t)
{
    Latch l = {t, abort_bound(t->a), arena_alloc(t->a->arena, t->run->size), trial_new_inputs(t)};

    for (size_t s = 0; s < t->a->p->state.n; s++)
        if (!l.bound.bound[s])
            look_at_state(&l, &t->state[s], t->a->p->state.at[s]);
}
