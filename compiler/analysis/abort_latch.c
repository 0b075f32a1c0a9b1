// SPDX-License-Identifier: Apache-2.0
// States that abort at once when they begin again, because what was set on the way to the last abort is still set.
//
// Of two situations at the beginning of a state, one goes to an @abort state within two steps with all healthy readings, windows full
// of them, with which the other one does not.  A variable that the transition reads and that differs between the two is the reason.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/questions.h"

enum { DRAWS = 40, AT_ONCE = 2 };

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

// The transition that it makes to an abort within two steps; NULL: it makes another, or none.
static const Transition *aborts_at_once(Latch *l, const TrialEntry *e)
{
    Trials *t = l->t;

    trial_copy(t, l->at, e->situation);
    ir_run_fill(t->run, l->at, t->window, healthy_inputs, l);
    for (int k = 0; k < AT_ONCE; k++) {
        const Transition *made;
        trial_step(t, l->at, l->in, t->dt, &t->trace);
        made = t->trace.transition ? t->transition[t->trace.transition] : NULL;
        if (made)
            return l->bound.bound[made->to->number - 1] ? made : NULL;
    }
    return NULL;
}

// The transition that it makes whenever the other one does not abort; NULL: not always, or the other one always does.
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

typedef struct Differs { const Latch *l; const double *again, *first; const Var *found; } Differs;

static void look_at_var(Expr *e, void *context)
{
    Differs *d = context;
    const uint32_t v = e->kind == EX_VAR ? d->l->t->a->m->var_of[e->var->index] : IR_NONE;

    if (v != IR_NONE && e->var->written && !d->found && d->again[v] != d->first[v])
        d->found = e->var;
}

static bool look_at_pair(Latch *l, const State *state, const TrialEntry *e, const TrialEntry *other)
{
    const Analysis *a = l->t->a;
    const Transition *made = aborts_where_not(l, e, other);
    Differs d = {l, ir_run_vars(l->t->run, e->situation), ir_run_vars(l->t->run, other->situation), NULL};

    for (const Condition *c = made ? made->when : NULL; c; c = c->outer)
        expr_walk(c->stmt->value, look_at_var, &d);
    if (d.found)
        diag_report(a->diags, DIAG_abort_latch, made->stmt->span, state->name->text, d.found->name->text,
                    const_text(a->arena, d.again[a->m->var_of[d.found->index]]));
    return d.found != NULL;
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
