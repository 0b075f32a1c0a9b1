// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/guards_known.h"

#include "compiler/analysis/assume.h"
#include "compiler/analysis/decided_comparison.h"
#include "stdlib/f64.h"

enum { TRIED = 64 };              // how many earlier guards and assignments are checked

// ---- the walk ----

typedef struct Walk { Analysis *a; KnownStmt *f; void *context; } Walk;

static const Known *with_guard(Arena *arena, const Known *outer, const Expr *guard, bool holds)
{
    Known *k = ARENA_NEW(arena, Known);

    *k = (Known){guard, holds, NULL, outer};
    return k;
}

static const Known *with_assigned(Arena *arena, const Known *outer, const Stmt *assigned)
{
    Known *k = ARENA_NEW(arena, Known);

    *k = (Known){NULL, false, assigned, outer};
    return k;
}

typedef struct After { const Known *known; bool leaves; } After;

static After walk(Walk *w, const Stmts *stmts, const Known *known);

// Adds the assignments of a branch.  After the conditional they may or may not have been executed.
static const Known *with_assigned_in(Arena *arena, const Known *known, const Known *arm, const Known *begin)
{
    for (; arm && arm != begin; arm = arm->outer)
        if (arm->assigned)
            known = with_assigned(arena, known, arm->assigned);
    return known;
}

// A branch that always leaves does not reach the statements after it.  There the opposite of its guard is known.
static After walk_if(Walk *w, const Stmt *stmt, const Known *known)
{
    const Known *yes = with_guard(w->a->arena, known, stmt->value, true), *no = with_guard(w->a->arena, known, stmt->value, false);
    const After then = walk(w, &stmt->then, yes), otherwise = walk(w, &stmt->otherwise, no);
    const Known *after = then.leaves && !otherwise.leaves ? no : otherwise.leaves && !then.leaves ? yes : known;

    if (!then.leaves)
        after = with_assigned_in(w->a->arena, after, then.known, yes);
    if (!otherwise.leaves)
        after = with_assigned_in(w->a->arena, after, otherwise.known, no);
    return (After){after, then.leaves && otherwise.leaves};
}

// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static After walk(Walk *w, const Stmts *stmts, const Known *known)
{
    After at = {known, false};

    for (size_t i = 0; i < stmts->n && !at.leaves; i++) {
        const Stmt *stmt = stmts->at[i];
        w->f(w->context, stmt, at.known);
        if (stmt->kind == ST_IF)
            at = walk_if(w, stmt, at.known);
        else if (stmt->kind == ST_ASSIGN)
            at.known = with_assigned(w->a->arena, at.known, stmt);
        else
            at.leaves = true;
    }
    return at;
}

void known_each(Analysis *a, const Stmts *block, KnownStmt *f, void *context)
{
    Walk w = {a, f, context};

    walk(&w, block, NULL);
}

// `b != 0 and a / b > 5`: if b is 0 the whole is false, whatever the other side evaluates to.
void known_within(Analysis *a, const Expr *e, const Known *known, bool (*wanted)(const Expr *e), KnownExpr *f, void *context)
{
    const bool logic = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);

    if (wanted(e))
        f(context, e, known);
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++) {
        const Known *here = logic ? with_guard(a->arena, known, e->arg[1 - i], e->op == SM_OP_AND) : known;
        known_within(a, e->arg[i], here, wanted, f, context);
    }
}

// ---- conclusions ----

static bool is_same(const Analysis *a, const Expr *x, const Expr *y) { return expr_equal(x, y, a->m->window_of); }

static bool is_call(const Expr *e, SmBuiltin fn) { return e->kind == EX_CALL && e->fn == fn; }

// x, or its magnitude, is d or its magnitude.
static bool is_size_of(const Analysis *a, const Expr *x, const Expr *d)
{
    return is_same(a, is_call(x, SM_FN_abs) ? x->arg[0] : x, is_call(d, SM_FN_abs) ? d->arg[0] : d);
}

static IrOp op_of(SmOperator op, bool holds, bool mirrored)
{
    switch ((int)op) {
    case SM_OP_EQ: return holds ? IR_eq : IR_ne;
    case SM_OP_NE: return holds ? IR_ne : IR_eq;
    case SM_OP_LT: return holds ? (mirrored ? IR_gt : IR_lt) : mirrored ? IR_le : IR_ge;
    case SM_OP_LE: return holds ? (mirrored ? IR_ge : IR_le) : mirrored ? IR_lt : IR_gt;
    case SM_OP_GT: return holds ? (mirrored ? IR_lt : IR_gt) : mirrored ? IR_ge : IR_le;
    }
    return holds ? (mirrored ? IR_le : IR_ge) : mirrored ? IR_gt : IR_lt;
}

// Whether x op y is false if x, which is d or its magnitude, is 0.
static bool contradicts_zero(const Analysis *a, const Expr *x, IrOp op, const Expr *y, const Expr *d)
{
    const IrIns i = {.op = op, .type = SM_BOOL};
    const Fact zero = fact_of_number(sm_from_i32(0)), other = fact_of_types(a, y);

    return is_size_of(a, x, d) && fact_of_result(&i, &zero, &other, SM_F64).hi == 0;
}

static bool pair_excludes(const Analysis *a, const Expr *x, SmOperator op, const Expr *y, bool holds, const Expr *d)
{
    const IrOp o = op_of(op, holds, false);
    const bool unequal = o == IR_lt || o == IR_gt || o == IR_ne;

    if (unequal && d->kind == EX_BINARY && d->op == SM_OP_SUB &&
        ((is_same(a, x, d->arg[0]) && is_same(a, y, d->arg[1])) || (is_same(a, x, d->arg[1]) && is_same(a, y, d->arg[0]))))
        return true;
    return contradicts_zero(a, x, o, y, d) || contradicts_zero(a, y, op_of(op, holds, true), x, d);
}

// For a guard without `and`, `or` and `not`.
static bool comparison_excludes(const Analysis *a, const Expr *g, bool holds, const Expr *d)
{
    if (g->kind == EX_BINARY && is_comparison(g->op))
        return pair_excludes(a, g->arg[0], g->op, g->arg[1], holds, d);
    for (uint32_t i = 0; g->kind == EX_CHAIN && holds && i + 1 < g->n; i++)
        if (pair_excludes(a, g->arg[i], expr_ops(g)[i], g->arg[i + 1], true, d))
            return true;
    return holds && is_same(a, g, d);
}

static int sign_of(const Analysis *a, const Expr *e)
{
    const Fact f = fact_of_types(a, e);

    return f.lo >= 0 ? 1 : f.hi <= 0 ? -1 : 0;
}

// A sum, difference or maximum that is 0 only if both operands are 0, because they cannot cancel.
static bool is_zero_only_with_both(const Analysis *a, const Expr *d)
{
    const bool is_sum = d->kind == EX_BINARY && d->op == SM_OP_ADD, is_difference = d->kind == EX_BINARY && d->op == SM_OP_SUB;
    int one, other;

    if (!is_sum && !is_difference && !is_call(d, SM_FN_max))
        return false;
    one = sign_of(a, d->arg[0]);
    other = sign_of(a, d->arg[1]);
    if (is_call(d, SM_FN_max))
        return one > 0 && other > 0;
    return one != 0 && other == (is_sum ? one : -one);
}

// Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX bounds.
static bool part_excludes(const Analysis *a, const Expr *g, bool holds, const Expr *d)
{
    if (comparison_excludes(a, g, holds, d))
        return true;
    if (d->kind == EX_UNARY && d->op == SM_OP_NEG)
        return part_excludes(a, g, holds, d->arg[0]);
    return is_zero_only_with_both(a, d) && (part_excludes(a, g, holds, d->arg[0]) || part_excludes(a, g, holds, d->arg[1]));
}

// Whether g being true (or false) excludes that d is 0.
static bool guard_excludes(const Analysis *a, const Expr *g, bool holds, const Expr *d)
{
    if (g->kind == EX_UNARY && g->op == SM_OP_NOT)
        return guard_excludes(a, g->arg[0], !holds, d);
    if (g->kind == EX_BINARY && (g->op == SM_OP_AND || g->op == SM_OP_OR)) {
        const bool one = guard_excludes(a, g->arg[0], holds, d), other = guard_excludes(a, g->arg[1], holds, d);
        return holds == (g->op == SM_OP_AND) ? one || other : one && other;
    }
    return part_excludes(a, g, holds, d);
}

static bool mentions(const Expr *e, const Var *v)
{
    if (e->kind == EX_VAR && e->var == v)
        return true;
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        if (mentions(e->arg[i], v))
            return true;
    return false;
}

// A guard no longer counts if a variable that it reads was assigned after it was evaluated.
static bool some_guard_excludes(const Analysis *a, const Known *known, const Expr *d)
{
    const Var *assigned[TRIED];
    size_t n = 0;

    for (size_t i = 0; known && i < TRIED; i++, known = known->outer) {
        bool stale = false;
        if (known->assigned)
            assigned[n++] = known->assigned->var;
        for (size_t v = 0; known->guard && v < n; v++)
            stale |= mentions(known->guard, assigned[v]);
        if (known->guard && !stale && guard_excludes(a, known->guard, known->holds, d))
            return true;
    }
    return false;
}

static bool operator_keeps(const Analysis *a, const Known *known, const Expr *d)
{
    if (d->kind == EX_UNARY)
        return d->op == SM_OP_NEG && known_not_zero(a, known, d->arg[0]);
    if (is_call(d, SM_FN_abs) || is_call(d, SM_FN_sqrt))
        return known_not_zero(a, known, d->arg[0]);
    if (d->kind != EX_BINARY)
        return false;
    if (d->op == SM_OP_MUL)
        return known_not_zero(a, known, d->arg[0]) && known_not_zero(a, known, d->arg[1]);
    return d->op == SM_OP_DIV && known_not_zero(a, known, d->arg[0]);
}

bool known_not_zero(const Analysis *a, const Known *known, const Expr *d)
{
    const Fact f = fact_of_types(a, d);

    return f.lo > 0 || f.hi < 0 || some_guard_excludes(a, known, d) || operator_keeps(a, known, d);
}
