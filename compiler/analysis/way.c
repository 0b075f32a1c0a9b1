// SPDX-License-Identifier: Apache-2.0
// Ways: statements executed on sums of atoms.  Conditions become formulas (way_formula.c decides them).
#include "compiler/analysis/way_formula.h"

// ---- variables ----

static void hold(Way *w, WayValue value)
{
    for (size_t i = 0; i < w->assigned.n; i++)
        if (w->assigned.at[i].var == value.var) {
            w->assigned.at[i] = value;
            return;
        }
    vec_push(w->a->arena, &w->assigned, value);
}

static bool is_whole(SmType type) { return sm_type_info[type].kind != SM_KIND_FLOAT; }

static void assign(Way *w, const Var *v, const Expr *e)
{
    WayValue value = {.var = v};

    if (v->type == SM_BOOL) {
        value.yes = way_formula(w, e, true);
        value.no = way_formula(w, e, false);
        value.sum = way_unknown(w, true);
    } else {
        value.sum = way_sum(w, e);
        if (is_whole(v->type) && !way_sum_is_whole(w, &value.sum))
            value.sum = way_unknown(w, true);
    }
    hold(w, value);
}

// Somebody may have assigned these.
static void forget(Way *w, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->kind == ST_ASSIGN)
            hold(w, (WayValue){.var = s->var, .sum = way_unknown(w, is_whole(s->var->type))});
        forget(w, &s->then);
        forget(w, &s->otherwise);
    }
}

// ---- statements ----

static void demand(Way *w, const WayFormula *f) { vec_push(w->a->arena, &w->demand, f); }

static void pass(Way *w, const Stmts *stmts);

// Past a conditional without leaving in it.
static void pass_if(Way *w, const Stmt *s)
{
    const bool then = always_leaves(&s->then), otherwise = always_leaves(&s->otherwise);

    if (then || otherwise) {
        if (!w->alone)
            demand(w, way_formula(w, s->value, otherwise));
        pass(w, then ? &s->otherwise : &s->then);
        return;
    }
    forget(w, &s->then);
    forget(w, &s->otherwise);
}

static void pass_one(Way *w, const Stmt *s)
{
    switch (s->kind) {
    case ST_ASSIGN: assign(w, s->var, s->value); break;
    case ST_IF: pass_if(w, s); break;
    case ST_TRANSITION: demand(w, way_never()); break;
    }
}

static void pass(Way *w, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++)
        pass_one(w, stmts->at[i]);
}

static void pass_until(Way *w, const Stmts *stmts, const Stmt *end)
{
    for (size_t i = 0; i < stmts->n && stmts->at[i] != end; i++)
        pass_one(w, stmts->at[i]);
}

// As deep as conditionals nest: AST_DEPTH_MAX bounds it.  Gives the list that the condition leads into.
static const Stmts *pass_to(Way *w, const Stmts *stmts, const Condition *c, bool fulfil)
{
    if (!c)
        return stmts;
    stmts = pass_to(w, stmts, c->outer, fulfil);
    pass_until(w, stmts, c->stmt);
    if (fulfil)
        demand(w, way_formula(w, c->stmt->value, c->holds));
    return c->holds ? &c->stmt->then : &c->stmt->otherwise;
}

// ---- steps ----

static void begin_step(Way *w, const Transition *t, bool first)
{
    const Program *p = w->a->p;

    if (!first)
        return;
    hold(w, (WayValue){.var = p->t, .sum = {0}});
    if (t->block == BLOCK_STEP)
        pass(w, &t->from->block[BLOCK_ENTRY]);
}

Way way_begin(const Analysis *a)
{
    Way w = {.a = a};

    return w;
}

void way_step(Way *w, const Transition *t, bool first)
{
    begin_step(w, t, first);
    pass_until(w, pass_to(w, &t->from->block[t->block], t->when, true), t->stmt);
    pass(w, &t->from->block[BLOCK_EXIT]);
}

void way_step_alone(Way *w, const Transition *t)
{
    w->alone = true;
    way_step(w, t, false);
    w->alone = false;
}

bool way_possible(const Way *w)
{
    return way_decide(w, NULL);
}

// All conditions together, negated: one of them fails.
static const WayFormula *one_fails(Way *w, const Condition *c)
{
    const WayFormula *out = way_never();

    for (; c; c = c->outer)
        out = way_or(w, out, way_formula(w, c->stmt->value, !c->holds));
    return out;
}

bool way_forces(const Way *w, const Transition *t)
{
    Way next = *w;

    if (!t->when)
        return false;
    next.assigned.at = NULL;
    next.assigned.n = next.assigned.cap = 0;
    for (size_t i = 0; i < w->assigned.n; i++)
        vec_push(w->a->arena, &next.assigned, w->assigned.at[i]);
    next.demand.cap = next.demand.n;                  // what is appended goes elsewhere
    begin_step(&next, t, true);
    pass_to(&next, &t->from->block[t->block], t->when, false);
    return way_possible(&next) && !way_decide(&next, one_fails(&next, t->when));
}

bool way_counts(const Way *w, const Var *v)
{
    for (size_t i = 0; i < w->assigned.n; i++) {
        const WaySum *s = &w->assigned.at[i].sum;
        if (w->assigned.at[i].var == v)
            return s->n == 1 && s->constant != 0 && w->atom.at[s->term[0].atom].var == v;
    }
    return false;
}
