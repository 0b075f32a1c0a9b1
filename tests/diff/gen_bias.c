// SPDX-License-Identifier: Apache-2.0
// Adds guards that analyses report, and that random programs contain too rarely: one guard twice, one that another implies or excludes, and two
// that cover every case.  They are in chains and in sequences, followed by transitions or assignments.
#include "tests/diff/sound.h"

static GExpr *pair(Gen *g, SmOperator op, GExpr *a, GExpr *b)
{
    GExpr *e = gen_expr_new(g, G_BINARY, 2);
    e->op = op;
    e->arg[0] = a;
    e->arg[1] = b;
    return e;
}

static GExpr *number(Gen *g, uint32_t below)
{
    GExpr *e = gen_expr_new(g, G_NUMBER, 0);
    e->text = format_in(g->arena, "%u", (unsigned)rng_below(&g->rng, below));
    return e;
}

// Whether every relational operator is valid in e.  If an operand is the name of a state, only == and != are.
static bool compares(const GExpr *e)
{
    return e->kind == G_BINARY && e->op >= SM_OP_EQ && e->op <= SM_OP_GE && e->arg[0]->kind != G_STATE && e->arg[1]->kind != G_STATE;
}

static GExpr *opposite(Gen *g, GExpr *e)
{
    static const SmOperator other[] = { SM_OP_NE, SM_OP_EQ, SM_OP_GE, SM_OP_GT, SM_OP_LE, SM_OP_LT };
    GExpr *n;
    if (compares(e))
        return pair(g, other[e->op - SM_OP_EQ], e->arg[0], e->arg[1]);
    n = gen_expr_new(g, G_UNARY, 1);
    n->op = SM_OP_NOT;
    n->arg[0] = e;
    return n;
}

// Returns a similar relation: with another operator, or with a number added to its right side.
static GExpr *moved(Gen *g, GExpr *e)
{
    GExpr *right;
    if (!compares(e))
        return pair(g, SM_OP_AND, e, gen_plain_guard(g));
    right = rng_percent(&g->rng, 70) ? pair(g, rng_percent(&g->rng, 50) ? SM_OP_ADD : SM_OP_SUB, e->arg[1], number(g, 10)) : e->arg[1];
    return pair(g, rng_percent(&g->rng, 60) ? e->op : (SmOperator)(SM_OP_EQ + rng_below(&g->rng, 6)), e->arg[0], right);
}

static GExpr *biased_guard(Gen *g, GExpr *e)
{
    switch (rng_below(&g->rng, 8)) {
    case 0: return e;
    case 1: return moved(g, e);
    case 2: return opposite(g, e);
    case 3: return pair(g, SM_OP_AND, e, gen_plain_guard(g));
    case 4: return pair(g, SM_OP_OR, e, moved(g, e));
    case 5: return pair(g, rng_percent(&g->rng, 50) ? SM_OP_AND : SM_OP_OR, gen_plain_guard(g), gen_plain_guard(g));
    case 6: return pair(g, SM_OP_AND, e, moved(g, opposite(g, e)));
    }
    return gen_plain_guard(g);
}

static GStmt *conditional(Gen *g, GExpr *guard, GStmt *body)
{
    GStmt *s = ARENA_NEW(g->arena, GStmt);
    s->kind = G_IF;
    s->value = guard;
    vec_push(g->arena, &s->then, body);
    return s;
}

static GStmt *transition(Gen *g)
{
    GStmt *s = ARENA_NEW(g->arena, GStmt);
    s->kind = G_GOTO;
    s->target = g->state.at[rng_below(&g->rng, (uint32_t)g->state.n)];
    return s;
}

// The statement after a new guard: a transition, or one of the program's assignments.
static GStmt *body(Gen *g, const GStmts *assigns, bool may_leave)
{
    if (assigns->n == 0 || (may_leave && rng_percent(&g->rng, 70)))
        return may_leave ? transition(g) : NULL;
    return assigns->at[rng_below(&g->rng, (uint32_t)assigns->n)];
}

static void bias_list(Gen *g, GStmts *list, const GStmts *assigns, bool may_leave)
{
    GStmts out = { 0 };
    for (size_t i = 0; i < list->n; i++) {
        GStmt *s = list->at[i], *more = NULL;
        bias_list(g, &s->then, assigns, may_leave);
        bias_list(g, &s->otherwise, assigns, may_leave);
        vec_push(g->arena, &out, s);
        if (s->kind == G_IF && rng_percent(&g->rng, 60))
            more = body(g, assigns, may_leave);
        if (more == NULL)
            continue;
        more = conditional(g, biased_guard(g, s->value), more);
        if (!s->has_else && rng_percent(&g->rng, 40)) {
            s->has_else = true;
            vec_push(g->arena, &s->otherwise, more);
        } else {
            vec_push(g->arena, &out, more);
        }
    }
    *list = out;
}

static void collect(Gen *g, const GStmts *list, GStmts *assigns)
{
    for (size_t i = 0; i < list->n; i++) {
        if (list->at[i]->kind == G_ASSIGN)
            vec_push(g->arena, assigns, list->at[i]);
        collect(g, &list->at[i]->then, assigns);
        collect(g, &list->at[i]->otherwise, assigns);
    }
}

void gen_bias(Gen *g)
{
    GStmts assigns = { 0 };
    for (size_t s = 0; s < g->state.n; s++)
        for (int b = 0; b < 3; b++)
            collect(g, &g->state.at[s]->block[b], &assigns);
    for (size_t s = 0; s < g->state.n; s++)
        for (int b = 0; b < 3; b++)
            bias_list(g, &g->state.at[s]->block[b], &assigns, b < 2);
}
