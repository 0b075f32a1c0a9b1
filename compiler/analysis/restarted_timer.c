// SPDX-License-Identifier: Apache-2.0
// Reports a limit to a time or count over two states that begins again whenever one leads back to the other.
//
// Both states count (or compare G with one stored time), and both leave for the same state at the limit: so it counts for both.  But .entry of
// one resets it, and the other leads back to that one without a command.  Where only that state had the limit, T would do: a limit to one phase
// of several is meant to begin again, and says nothing here.
#include "compiler/analysis/carried.h"
#include "compiler/analysis/input_deps.h"

typedef struct TimerCheck {
    CarriedTable t;
    const InputDepsTable *deps;
} TimerCheck;

// Whether e contains a comparison of the variable with a limit.
static bool compares(const Expr *e, const Var *v)
{
    bool found = false;

    for (uint32_t i = 0; i < comparison_count(e) && !found; i++) {
        const Comparison c = comparison_at(e, i);
        found = c.op != SM_OP_EQ && c.op != SM_OP_NE && (expr_reads(c.a, v) || expr_reads(c.b, v));
    }
    for (uint32_t i = 0; i < e->n && !found; i++)
        found = compares(e->arg[i], v);
    return found;
}

// Returns the transition out of the state that the variable's limit causes; NULL: the limit causes none.
static const Transition *find_limit(const TimerCheck *k, const State *s, const Var *v)
{
    const Analysis *a = k->t.a;

    for (size_t i = k->t.first[s->number - 1]; i < k->t.first[s->number]; i++) {
        const Transition *way = &a->transition.at[i];
        if (way->when && way->when->holds && a->stmt[way->stmt->number].reached && compares(way->when->stmt->value, v))
            return way;
    }
    return NULL;
}

// Whether the variable goes on in the state: a count that the state raises, or a time that the state leaves as it is.
static bool goes_on_in(const Carried *c, const State *s, const State *reset_in)
{
    bool counts = c->kind == CARRIED_STAMP, resets = false;

    for (size_t i = 0; i < c->store.n; i++) {
        const CarriedStore *r = &c->store.at[i];
        counts |= r->state == s && !r->resets && r->block == BLOCK_STEP && r->list == &s->block[BLOCK_STEP];
        resets |= r->state == s && r->resets && (s != reset_in || r->block != BLOCK_ENTRY);
    }
    return counts && !resets;
}

static bool is_between_runs(const Analysis *a, const State *s) { return s->is_safe || s->is_abort || s == a->p->state.at[0]; }

// Returns the transition from another state back to the one that resets the variable, if both have the limit; else NULL.
static const Transition *find_way_back(const TimerCheck *k, size_t v, const CarriedStore *reset)
{
    const Analysis *a = k->t.a;
    const Transition *limit = find_limit(k, reset->state, a->p->var.at[v]);

    for (size_t i = 0; limit && i < a->transition.n; i++) {
        const Transition *way = &a->transition.at[i];
        const Transition *other = way->to == reset->state && way->from != way->to ? find_limit(k, way->from, a->p->var.at[v]) : NULL;
        if (other && other->to == limit->to && !is_between_runs(a, way->from) && goes_on_in(&k->t.of[v], way->from, NULL) &&
            a->stmt[way->stmt->number].reached && !input_deps_of_condition(k->deps, way->when).command)
            return way;
    }
    return NULL;
}

// Whether a transition of the state leads to the other one: without it the machine does not alternate between the two.
static bool leads_to(const Analysis *a, const State *from, const State *to)
{
    bool leads = false;

    for (size_t i = 0; i < a->transition.n && !leads; i++)
        leads = a->transition.at[i].from == from && a->transition.at[i].to == to && a->stmt[a->transition.at[i].stmt->number].reached;
    return leads;
}

static void check_reset(const TimerCheck *k, size_t v, const CarriedStore *reset)
{
    const Analysis *a = k->t.a;
    const Transition *back;
    Diag *d;

    if (!reset->resets || reset->block != BLOCK_ENTRY || reset->list != &reset->state->block[BLOCK_ENTRY] ||
        is_between_runs(a, reset->state) || !goes_on_in(&k->t.of[v], reset->state, reset->state))
        return;
    back = find_way_back(k, v, reset);
    if (!back || !leads_to(a, reset->state, back->from))
        return;
    d = diag_report(a->diags, DIAG_restarted_timer, reset->stmt->span, a->p->var.at[v]->name->text, back->from->name->text,
                    reset->state->name->text);
    diag_note(a->diags, d, back->stmt->span, DIAG_note_transition_to, reset->state->name->text);
    diag_note(a->diags, d, find_limit(k, back->from, a->p->var.at[v])->when->stmt->value->span, DIAG_note_limit_here, a->p->var.at[v]->name->text);
}

void analyse_restarted_timer(Analysis *a)
{
    const TimerCheck k = {carried_of(a), input_deps_of(a)};

    for (size_t v = 0; v < a->p->var.n; v++)
        for (size_t i = 0; (k.t.of[v].kind == CARRIED_COUNT || k.t.of[v].kind == CARRIED_STAMP) && i < k.t.of[v].store.n; i++)
            check_reset(&k, v, &k.t.of[v].store.at[i]);
}
