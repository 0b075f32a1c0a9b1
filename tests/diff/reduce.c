// SPDX-License-Identifier: Apache-2.0
// Makes one small cut after another.  A cut remains if the program still fails with it.  Ends when a whole round makes no cut.
#include "tests/diff/reduce.h"

#include <string.h>

enum { RUNS_MAX = 6000 };

typedef struct Reducer {
    Gen *g;
    const RunOptions *o;
    RunResult now;
    Arena *arena;
    uint32_t runs;
    bool progress;
} Reducer;

// Whether the program still fails with the cut that was just made.
static bool still_fails(Reducer *r)
{
    if (r->runs++ >= RUNS_MAX)
        return false;
    const RunResult next = run_case(r->g, r->o, r->arena);
    if (next.verdict != r->now.verdict)
        return false;
    r->now = next;
    r->progress = true;
    return true;
}

static void try_bool(Reducer *r, bool *flag, bool value)
{
    if (*flag == value)
        return;
    *flag = value;
    if (!still_fails(r))
        *flag = !value;
}

// ---- expressions ----

static GExpr *simple_number(Reducer *r, const char *text)
{
    GExpr *e = ARENA_NEW(r->g->arena, GExpr);
    e->kind = G_NUMBER;
    e->text = text;
    return e;
}

static bool try_expr(Reducer *r, GExpr **place, GExpr *other)
{
    GExpr *old = *place;
    *place = other;
    if (still_fails(r))
        return true;
    *place = old;
    return false;
}

static void reduce_size(Reducer *r, GExpr **place)
{
    static const char *const small[] = { "1", "2", "3", "4" };
    for (int i = 0; i < 4; i++) {
        if ((*place)->kind == G_NUMBER && strcmp((*place)->text, small[i]) == 0)
            return;
        if (try_expr(r, place, simple_number(r, small[i])))
            return;
    }
}

static void reduce_expr(Reducer *r, GExpr **place)
{
    GExpr *e = *place;
    if (e->kind == G_NUMBER && strlen(e->text) == 1)
        return;
    if (try_expr(r, place, simple_number(r, "0")) || try_expr(r, place, simple_number(r, "1")))
        return;
    if (e->kind == G_DEFINED && try_expr(r, place, e->def->value)) {
        reduce_expr(r, place);
        return;
    }
    const uint32_t n = e->kind == G_ROLL ? 1 : e->n;          // the size of a window is not a value
    for (uint32_t i = 0; i < n; i++)
        if (e->arg[i]->kind != G_STATE && try_expr(r, place, e->arg[i])) {
            reduce_expr(r, place);
            return;
        }
    for (uint32_t i = 0; i < n; i++)
        if (e->arg[i]->kind != G_STATE)
            reduce_expr(r, &e->arg[i]);
    if (e->kind == G_ROLL)
        reduce_size(r, &e->arg[1]);
}

// ---- statements ----

static void reduce_stmts(Reducer *r, GStmts *list);

static bool try_without(Reducer *r, GStmts *list, size_t i)
{
    const GStmts old = *list;
    GStmt **at = ARENA_ARRAY(r->g->arena, GStmt *, old.n);
    memcpy(at, old.at, old.n * sizeof *at);
    memmove(at + i, at + i + 1, (old.n - i - 1) * sizeof *at);
    list->at = at;
    list->n = list->cap = old.n - 1;
    if (still_fails(r))
        return true;
    *list = old;
    return false;
}

// Replaces a conditional by its own statements.
static bool try_inlined(Reducer *r, GStmts *list, size_t i, const GStmts *inner)
{
    const GStmts old = *list;
    const uint32_t n = old.n - 1 + inner->n;
    GStmt **at = ARENA_ARRAY(r->g->arena, GStmt *, n);
    memcpy(at, old.at, i * sizeof *at);
    if (inner->n > 0)
        memcpy(at + i, inner->at, inner->n * sizeof *at);
    memcpy(at + i + inner->n, old.at + i + 1, (old.n - i - 1) * sizeof *at);
    list->at = at;
    list->n = list->cap = n;
    if (still_fails(r))
        return true;
    *list = old;
    return false;
}

static void reduce_if(Reducer *r, GStmts *list, size_t i)
{
    GStmt *s = list->at[i];
    if (try_inlined(r, list, i, &s->then) || (s->has_else && try_inlined(r, list, i, &s->otherwise)))
        return;
    try_bool(r, &s->has_else, false);
    reduce_stmts(r, &s->then);
    if (s->has_else)
        reduce_stmts(r, &s->otherwise);
    reduce_expr(r, &s->value);
}

static void reduce_stmts(Reducer *r, GStmts *list)
{
    for (size_t i = list->n; i-- > 0; )
        if (i < list->n && !try_without(r, list, i)) {
            if (list->at[i]->kind == G_IF)
                reduce_if(r, list, i);
            else if (list->at[i]->kind == G_ASSIGN)
                reduce_expr(r, &list->at[i]->value);
        }
}

// ---- additions ----

static bool expr_uses(const GExpr *e, const GDef *d)
{
    bool found = e->kind == G_DEFINED && e->def == d;
    for (uint32_t i = 0; i < e->n && !found; i++)
        found = expr_uses(e->arg[i], d);
    return found;
}

static bool stmts_use(const GStmts *list, const GDef *d)
{
    bool found = false;
    for (size_t i = 0; i < list->n && !found; i++) {
        const GStmt *s = list->at[i];
        found = (s->value != NULL && expr_uses(s->value, d)) || stmts_use(&s->then, d) || stmts_use(&s->otherwise, d);
    }
    return found;
}

static bool is_used(const Gen *g, const GDef *d)
{
    bool found = false;
    for (size_t i = 0; i < g->def.n; i++)
        found |= !g->def.at[i]->removed && expr_uses(g->def.at[i]->value, d);
    for (size_t i = 0; i < g->var.n; i++)
        found |= g->var.at[i]->init != NULL && !g->var.at[i]->removed && expr_uses(g->var.at[i]->init, d);
    for (size_t i = 0; i < g->rule.n; i++)
        found |= !g->rule.at[i]->removed && stmts_use(&g->rule.at[i]->block, d);
    for (size_t i = 0; i < g->state.n; i++)
        for (int b = 0; b < 3 && !g->state.at[i]->removed; b++)
            found |= stmts_use(&g->state.at[i]->block[b], d);
    return found;
}

static void reduce_additions(Reducer *r)
{
    Gen *g = r->g;
    for (size_t i = 0; i < g->rule.n; i++) {
        try_bool(r, &g->rule.at[i]->removed, true);
        if (!g->rule.at[i]->removed)
            reduce_stmts(r, &g->rule.at[i]->block);
    }
    for (size_t i = g->def.n; i-- > 0; ) {
        GDef *d = g->def.at[i];
        if (!d->removed && !is_used(g, d))
            try_bool(r, &d->removed, true);
        if (!d->removed && !d->is_size)
            reduce_expr(r, &d->value);
    }
}

// ---- variables: what nothing names any more may go ----

static bool expr_names(const GExpr *e, const GVar *v)
{
    bool found = e->kind == G_VAR && e->var == v;
    for (uint32_t i = 0; i < e->n && !found; i++)
        found = expr_names(e->arg[i], v);
    return found;
}

static bool stmts_name(const GStmts *list, const GVar *v)
{
    for (size_t i = 0; i < list->n; i++) {
        const GStmt *s = list->at[i];
        if (s->var == v || (s->value != NULL && expr_names(s->value, v)))
            return true;
        if (stmts_name(&s->then, v) || stmts_name(&s->otherwise, v))
            return true;
    }
    return false;
}

static bool is_named(const Gen *g, const GVar *v)
{
    for (size_t i = 0; i < g->state.n; i++)
        for (int b = 0; b < 3; b++)
            if (!g->state.at[i]->removed && stmts_name(&g->state.at[i]->block[b], v))
                return true;
    for (size_t i = 0; i < g->rule.n; i++)
        if (!g->rule.at[i]->removed && stmts_name(&g->rule.at[i]->block, v))
            return true;
    for (size_t i = 0; i < g->def.n; i++)
        if (!g->def.at[i]->removed && expr_names(g->def.at[i]->value, v))
            return true;
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->init != NULL && !g->var.at[i]->removed && expr_names(g->var.at[i]->init, v))
            return true;
    return false;
}

static void reduce_var(Reducer *r, GVar *v)
{
    const char *alias = v->alias;
    if (!is_named(r->g, v))
        try_bool(r, &v->removed, true);
    if (v->removed)
        return;
    try_bool(r, &v->is_set, false);
    try_bool(r, &v->outside, false);
    if (!v->parameter)
        try_bool(r, &v->read_only, false);
    if (alias != NULL) {
        v->alias = NULL;
        if (!still_fails(r))
            v->alias = alias;
    }
    if (v->init != NULL && v->roll_size == 0 && !v->parameter)
        reduce_expr(r, &v->init);
}

// ---- all of it ----

static bool is_last_state(const Gen *g)
{
    uint32_t left = 0;
    for (size_t i = 0; i < g->state.n; i++)
        left += !g->state.at[i]->removed;
    return left <= 1;
}

static void reduce_state(Reducer *r, GState *s)
{
    if (!is_last_state(r->g))
        try_bool(r, &s->removed, true);
    for (int b = 0; b < 3 && !s->removed; b++) {
        if (!s->present[b])
            continue;
        try_bool(r, &s->present[b], false);
        if (s->present[b])
            reduce_stmts(r, &s->block[b]);
        else
            s->block[b].n = 0;
    }
}

static void reduce_steps(Reducer *r)
{
    const uint32_t steps = r->g->steps;
    r->g->steps = r->now.step + 1;
    if (r->g->steps < steps && !still_fails(r))
        r->g->steps = steps;
    for (uint32_t k = 0; k < r->g->steps; k++)
        try_bool(r, &r->g->skip[k], true);
}

static void reduce_round(Reducer *r)
{
    try_bool(r, &r->g->plain, true);
    try_bool(r, &r->g->with_sv, false);
    reduce_steps(r);
    for (size_t i = r->g->state.n; i-- > 0; )
        if (!r->g->state.at[i]->removed)
            reduce_state(r, r->g->state.at[i]);
    reduce_additions(r);
    for (size_t i = r->g->var.n; i-- > 2; )
        if (!r->g->var.at[i]->removed)
            reduce_var(r, r->g->var.at[i]);
}

RunResult reduce(Gen *g, const RunOptions *o, RunResult first, Arena *arena)
{
    Reducer r = { g, o, first, arena, 0, true };
    while (r.progress && r.runs < RUNS_MAX) {
        r.progress = false;
        reduce_round(&r);
    }
    return r.now;
}
