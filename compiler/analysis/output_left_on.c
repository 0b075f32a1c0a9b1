// SPDX-License-Identifier: Apache-2.0
// Outputs that stay on where the machine may rest: in a state marked @safe, and in one that nothing but a person ends.
//
// Every situation that the search found at the beginning of such a state is held with inputs at which the machine stays.  If an
// output that another state has switched on is still on after all that time, the finding is where the machine came in.
#include <string.h>

#include "compiler/analysis/questions.h"

enum { HELD = 6 };                // inputs tried in each situation

typedef struct LeftOn {
    Trials *t;
    void *at;
    double *in;
} LeftOn;

typedef struct Search { const LeftOn *l; const Var *v; const Stmt *off; } Search;

static void look_for_off(const Stmt *s, void *context)
{
    Search *k = context;
    const Fact f = k->l->t->a->stmt[s->number].value;

    if (s->kind == ST_ASSIGN && s->var == k->v && k->l->t->a->stmt[s->number].reached && f.lo <= 0 && f.hi >= 0)
        k->off = s;
}

static bool is_ever_off(const LeftOn *l, const Var *v)
{
    Search k = {l, v, NULL};

    each_stmt(l->t->a->p, look_for_off, &k);
    return k.off != NULL;
}

static void report(const LeftOn *l, const TrialEntry *e, const Var *v, const Stmt *on)
{
    const Analysis *a = l->t->a;
    const State *s = a->p->state.at[trial_state(e->situation) - 1];
    Diag *d;

    if (!is_ever_off(l, v)) {
        diag_report(a->diags, DIAG_output_never_off, on->span, v->name->text);
        return;
    }
    d = diag_report(a->diags, DIAG_output_left_on, e->via->stmt->span, v->name->text, e->via->from->name->text, s->name->text);
    diag_note(a->diags, d, on->span, DIAG_note_switched_on, v->name->text);
}

// Holds the inputs as long as any timer lasts.  False: the state is left.
static bool rests(LeftOn *l, uint32_t state)
{
    Trials *t = l->t;

    for (uint32_t n = t->window + t->count + 5; n > 0; n--) {
        trial_step(t, l->at, l->in, t->dt, &t->trace);
        if (trial_state(l->at) != state)
            return false;
    }
    for (uint32_t k = 0; k <= t->waits; k++) {
        trial_step(t, l->at, l->in, k < t->waits ? t->wait[k] + t->dt : 1e9, &t->trace);
        trial_step(t, l->at, l->in, t->dt, &t->trace);
        if (trial_state(l->at) != state)
            return false;
    }
    return true;
}

// What is on now and was switched on by another state.
static bool look_at_outputs(LeftOn *l, const TrialEntry *e, const State *s)
{
    Trials *t = l->t;
    const double *var = ir_run_vars(t->run, l->at);
    const uint32_t *writer = ir_run_writers(t->run, l->at);
    bool any = false;

    for (uint32_t v = 0; v < t->run->m->var.n; v++) {
        const Stmt *on = t->actuator[v] && var[v] != 0 ? question_stmt(t, writer[v]) : NULL;
        if (!on || question_state(on, s))
            continue;
        report(l, e, t->var[v], on);
        any = true;
    }
    return any;
}

static void try_entry(LeftOn *l, const State *s, const TrialEntry *e)
{
    Trials *t = l->t;

    for (int n = 0; n < HELD; n++) {
        trial_copy(t, l->at, e->situation);
        memcpy(l->in, e->in, t->inputs * sizeof *l->in);
        for (uint32_t i = 0; i < t->inputs && n > 0; i++)
            if (t->input[i].command)
                l->in[i] = 0;
        if (n > 1)
            trial_draw(t, l->in, &t->state[s->number - 1], false, false);
        if (rests(l, s->number) && look_at_outputs(l, e, s))
            return;
    }
}

// Whether sensors and time can end the state.
static bool ends_by_itself(LeftOn *l, const State *s)
{
    Trials *t = l->t;
    const TrialState *ts = &t->state[s->number - 1];

    for (size_t n = 0; n < ts->entry.n && n < 4; n++)
        for (int k = 0; k < 4 * HELD; k++) {
            trial_copy(t, l->at, ts->entry.at[n].situation);
            memcpy(l->in, ts->entry.at[n].in, t->inputs * sizeof *l->in);
            trial_draw(t, l->in, ts, false, true);
            if (!rests(l, s->number))
                return true;
        }
    return false;
}

void question_output_left_on(Trials *t)
{
    LeftOn l = {t, arena_alloc(t->a->arena, t->run->size), trial_new_inputs(t)};

    for (size_t s = 0; s < t->a->p->state.n; s++) {
        const State *state = t->a->p->state.at[s];
        if (t->state[s].entry.n == 0 || (!state->is_safe && ends_by_itself(&l, state)))
            continue;
        for (size_t n = 0; n < t->state[s].entry.n; n++)
            if (t->state[s].entry.at[n].via)
                try_entry(&l, state, &t->state[s].entry.at[n]);
    }
}
