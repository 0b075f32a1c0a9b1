// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/outputs.h"

#include "stdlib/math.h"

bool may_be_on(Fact f) { return f.hi > 0 || f.lo < 0; }
bool is_on(Fact f) { return f.lo > 0 || f.hi < 0; }

// ---- which they are ----

enum { VALUES = 8 };

// The constants that an element is given.
typedef struct Given {
    bool written, other;                      // other: something that is no constant
    unsigned n;
    double value[VALUES], least, most;
} Given;

typedef struct Search {
    const Analysis *a;
    Given *given;                             // by Program.var
} Search;

static void add_value(Given *g, double x)
{
    if (g->n == 0 || x < g->least)
        g->least = x;
    if (g->n == 0 || x > g->most)
        g->most = x;
    for (unsigned i = 0; i < g->n && i < VALUES; i++)
        if (g->value[i] == x)
            return;
    if (g->n < VALUES)
        g->value[g->n] = x;
    g->n++;
}

static void look_at_assignment(const Stmt *s, void *context)
{
    const Search *search = context;
    const StmtFact *f = &search->a->stmt[s->number];
    Given *g;
    double x;

    if (s->kind != ST_ASSIGN || !f->reached)
        return;
    g = &search->given[s->var->index];
    g->written = true;
    if (fact_is_number(f->value, &x))
        add_value(g, x);
    else
        g->other = true;
}

static bool has_zero(const Given *g)
{
    for (unsigned i = 0; i < g->n && i < VALUES; i++)
        if (g->value[i] == 0)
            return true;
    return false;
}

// Percent lie far apart, codes close together.
static bool is_code(const Given *g)
{
    return g->n >= 3 && sm_trunc(g->least) == g->least && g->most - g->least < 2.0 * g->n;
}

static bool switches(const Var *v, const Given *g)
{
    if (v->kind != VAR_ELEMENT || !g->written)
        return false;
    return v->type == SM_BOOL || (!g->other && has_zero(g) && !is_code(g));
}

bool *outputs_find(const Analysis *a)
{
    Search search = {a, ARENA_ARRAY(a->arena, Given, a->p->var.n)};
    bool *out = ARENA_ARRAY(a->arena, bool, a->p->var.n);

    each_stmt(a->p, look_at_assignment, &search);
    for (size_t v = 0; v < a->p->var.n; v++)
        out[v] = switches(a->p->var.at[v], &search.given[v]);
    return out;
}

// ---- where they are switched ----

const Stmt *outputs_switch(const Analysis *a, const Stmts *stmts, const Var *v, bool on)
{
    const Stmt *found = NULL;

    for (size_t i = 0; i < stmts->n && !found; i++) {
        const Stmt *s = stmts->at[i];
        const StmtFact *f = &a->stmt[s->number];
        if (s->kind == ST_ASSIGN && s->var == v && f->reached && (on ? may_be_on(f->value) : !is_on(f->value)))
            found = s;
        if (!found)
            found = outputs_switch(a, &s->then, v, on);
        if (!found)
            found = outputs_switch(a, &s->otherwise, v, on);
    }
    return found;
}
