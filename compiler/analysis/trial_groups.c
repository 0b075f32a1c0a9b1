// SPDX-License-Identifier: Apache-2.0
// Finds out which sensors measure the same quantity, by union-find over the variables.
#include "compiler/analysis/trial_inputs.h"
#include "stdlib/math.h"

enum { COMPARISONS_MAX = 400 };         // the most comparisons of a machine that are compared with each other pairwise

// Returns the variable that represents the set of v in the union-find (TrialFinder.parent).
static uint32_t root_of(TrialFinder *f, uint32_t v)
{
    while (f->parent[v] != v)
        v = f->parent[v] = f->parent[f->parent[v]];
    return v;
}

// Records that two variables measure the same quantity, and returns one of them.  If one is IR_NONE (no variable), returns the other.
static uint32_t join_quantities(TrialFinder *f, uint32_t a, uint32_t b)
{
    if (a == IR_NONE || b == IR_NONE)
        return a == IR_NONE ? b : a;
    f->parent[root_of(f, b)] = root_of(f, a);
    return a;
}

// Whether the result of e measures the same quantity as its operands: a sum, a call, a statistic of a window, or a multiple by a
// constant.  Scaling changes the unit, but the result still moves with its sensor.
static bool preserves_quantity(const Expr *e)
{
    if (e->kind == EX_BINARY && (e->op == SM_OP_MUL || e->op == SM_OP_DIV))
        return expr_is_constant(e->arg[0]) || expr_is_constant(e->arg[1]);
    return (e->kind == EX_BINARY && (e->op == SM_OP_ADD || e->op == SM_OP_SUB)) || (e->kind == EX_UNARY && e->op == SM_OP_NEG)
        || e->kind == EX_ROLL || e->kind == EX_CALL;
}

// Whether a variable holds a quantity that sensors can measure: neither a time, nor a command, nor a bool.
static bool has_quantity(const TrialFinder *f, const Var *v)
{
    const uint32_t input = f->input_of[v->index];

    if (v->type == SM_BOOL || v->is_constant || v->kind == VAR_TIME || v == f->p->g || v == f->p->s)
        return false;
    return v->kind == VAR_LOCAL || v->written || (input != IR_NONE && !f->t->input[input].command);
}

// Joins the variables in e that must measure the same quantity, such as the two sides of a comparison.  Returns a variable (Var.index)
// that measures the same quantity as e; IR_NONE if none is known.
static uint32_t join_operands(TrialFinder *f, const Expr *e)
{
    const bool compared = comparison_count(e) > 0;
    uint32_t all = IR_NONE;

    if (e->kind == EX_VAR)
        return has_quantity(f, e->var) ? e->var->index : IR_NONE;
    for (uint32_t i = 0; i < e->n; i++) {
        const uint32_t q = join_operands(f, e->arg[i]);
        if (compared || preserves_quantity(e))
            all = join_quantities(f, all, q);
    }
    return compared ? IR_NONE : all;
}

// Joins the variables in a statement's value, and the assigned variable with the quantity of the value.
static void join_stmt(const StmtLocation *at, void *context)
{
    TrialFinder *f = context;
    uint32_t q;

    if (!at->stmt->value)
        return;
    q = join_operands(f, at->stmt->value);
    if (at->stmt->kind == ST_ASSIGN && at->stmt->var->type != SM_BOOL)
        join_quantities(f, at->stmt->var->index, q);
}

// Returns whether two expressions are equal except for their variables.  With `join_them`, joins variables at the same position.
static bool match_expressions(TrialFinder *f, const Expr *a, const Expr *b, bool join_them)
{
    bool alike = a->kind == b->kind && a->op == b->op && a->fn == b->fn && a->stat == b->stat && a->n == b->n;

    if (!alike || expr_is_constant(a) != expr_is_constant(b))
        return false;
    if (expr_is_constant(a))
        return expr_constant_value(a) == expr_constant_value(b);
    if (a->kind == EX_VAR) {
        const uint32_t x = join_operands(f, a), y = join_operands(f, b);
        if (x == IR_NONE || y == IR_NONE)
            return a->var == b->var;
        if (join_them)
            join_quantities(f, x, y);
        return true;
    }
    for (uint32_t i = 0; i < a->n && alike; i++)
        alike = match_expressions(f, a->arg[i], b->arg[i], join_them);
    return alike;
}

// Joins sensors that one state compares in the same way: they are assumed to measure the same quantity.
static void join_similar_comparisons(TrialFinder *f)
{
    const size_t n = f->comparison.n < COMPARISONS_MAX ? f->comparison.n : COMPARISONS_MAX;

    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < i; k++) {
            const TrialComparison *x = &f->comparison.at[i], *y = &f->comparison.at[k];
            const Comparison a = x->pair, b = y->pair;
            if (a.op == b.op && x->state == y->state && match_expressions(f, a.a, b.a, false) && match_expressions(f, a.b, b.b, false)) {
                match_expressions(f, a.a, b.a, true);
                match_expressions(f, a.b, b.b, true);
            }
        }
}

// Whether the overlap of two sensors' ranges is at least 80 percent of the wider range.  True if one sensor has no @range.
static bool have_similar_ranges(const TrialInput *a, const TrialInput *b)
{
    const double wide = sm_max(a->hi - a->lo, b->hi - b->lo);

    return !a->v->range || !b->v->range || sm_min(a->hi, b->hi) - sm_max(a->lo, b->lo) >= 0.8 * wide;
}

void trial_find_groups(TrialFinder *f)
{
    Trials *t = f->t;

    f->parent = ARENA_ARRAY(f->arena, uint32_t, f->p->var.n);
    for (uint32_t v = 0; v < f->p->var.n; v++)
        f->parent[v] = v;
    each_stmt_location(f->arena, f->p, join_stmt, f);
    join_similar_comparisons(f);
    for (uint32_t i = 0; i < t->inputs; i++)
        for (uint32_t k = 0; k < i && t->input[i].group == i; k++)
            if (!t->input[i].command && !t->input[k].command && have_similar_ranges(&t->input[i], &t->input[k]) &&
                root_of(f, t->input[i].v->index) == root_of(f, t->input[k].v->index))
                t->input[i].group = t->input[k].group;
}
