// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/guards_known.h"

#include "compiler/analysis/assume.h"
#include "compiler/analysis/decided_comparison.h"
#include "stdlib/f64.h"

enum { ENTRIES_MAX = 64 };        // at most this many entries of a list of KnownGuards are checked, the innermost first

// ---- the walk ----

typedef struct GuardWalk { Analysis *a; KnownGuardsStmt *f; void *context; } GuardWalk;

static const KnownGuard *add_guard(Arena *arena, const KnownGuard *outer, const Expr *guard, bool holds)
{
    KnownGuard *k = ARENA_NEW(arena, KnownGuard);

    *k = (KnownGuard){guard, holds, NULL, outer};
    return k;
}

static const KnownGuard *add_assignment(Arena *arena, const KnownGuard *outer, const Stmt *assigned)
{
    KnownGuard *k = ARENA_NEW(arena, KnownGuard);

    *k = (KnownGuard){NULL, false, assigned, outer};
    return k;
}

typedef struct GuardsAfter { const KnownGuard *known; bool leaves; } GuardsAfter;

static GuardsAfter walk_stmts(GuardWalk *w, const Stmts *stmts, const KnownGuard *known);

// Adds the assignments of a branch to `known`, because they may have been executed before the code after the conditional.  They are the
// entries of the list `arm` before `begin`, which is the entry for the branch itself.
static const KnownGuard *add_assignments_of(Arena *arena, const KnownGuard *known, const KnownGuard *arm, const KnownGuard *begin)
{
    for (; arm && arm != begin; arm = arm->outer)
        if (arm->assigned)
            known = add_assignment(arena, known, arm->assigned);
    return known;
}

// Walks a conditional.  If only one of its branches always leaves the state, the value of the guard that leads to the other branch is known
// after the conditional.
static GuardsAfter walk_if(GuardWalk *w, const Stmt *stmt, const KnownGuard *known)
{
    const KnownGuard *yes = add_guard(w->a->arena, known, stmt->value, true), *no = add_guard(w->a->arena, known, stmt->value, false);
    const GuardsAfter then = walk_stmts(w, &stmt->then, yes), otherwise = walk_stmts(w, &stmt->otherwise, no);
    const KnownGuard *after = then.leaves && !otherwise.leaves ? no : otherwise.leaves && !then.leaves ? yes : known;

    if (!then.leaves)
        after = add_assignments_of(w->a->arena, after, then.known, yes);
    if (!otherwise.leaves)
        after = add_assignments_of(w->a->arena, after, otherwise.known, no);
    return (GuardsAfter){after, then.leaves && otherwise.leaves};
}

// Walks a list of statements.  Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static GuardsAfter walk_stmts(GuardWalk *w, const Stmts *stmts, const KnownGuard *known)
{
    GuardsAfter at = {known, false};

    for (size_t i = 0; i < stmts->n && !at.leaves; i++) {
        const Stmt *stmt = stmts->at[i];
        w->f(w->context, stmt, at.known);
        if (stmt->kind == ST_IF)
            at = walk_if(w, stmt, at.known);
        else if (stmt->kind == ST_ASSIGN)
            at.known = add_assignment(w->a->arena, at.known, stmt);
        else
            at.leaves = true;
    }
    return at;
}

void guards_known_each_stmt(Analysis *a, const Stmts *block, KnownGuardsStmt *f, void *context)
{
    GuardWalk w = {a, f, context};

    walk_stmts(&w, block, NULL);
}

// Visits the expressions in e. Inside either operand of `and`, the other operand is assumed to be true: in `b != 0 and a / b > 5` the result is
// false if b is 0, whatever a / b is. Inside either operand of `or`, the other operand is assumed to be false.
void guards_known_each_expr(Analysis *a, const Expr *e, const KnownGuard *known, bool (*wanted)(const Expr *e), KnownGuardsExpr *f,
                            void *context)
{
    const bool logic = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);

    if (wanted(e))
        f(context, e, known);
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++) {
        const KnownGuard *here = logic ? add_guard(a->arena, known, e->arg[1 - i], e->op == SM_OP_AND) : known;
        guards_known_each_expr(a, e->arg[i], here, wanted, f, context);
    }
}

// ---- conclusions ----

static bool is_same_expr(const Analysis *a, const Expr *x, const Expr *y) { return expr_equal(x, y, a->m->window_of); }

static bool is_call(const Expr *e, SmBuiltin fn) { return e->kind == EX_CALL && e->fn == fn; }

// Whether `x op y` is false if d is 0: x and d are the same expression, apart from abs() around either, and `0 op y` is false.
static bool contradicts_zero(const Analysis *a, const Expr *x, SmOperator op, const Expr *y, const Expr *d)
{
    const Expr *x_inside = is_call(x, SM_FN_abs) ? x->arg[0] : x, *d_inside = is_call(d, SM_FN_abs) ? d->arg[0] : d;

    return is_same_expr(a, x_inside, d_inside) && fact_of_comparison(op, fact_of_number(sm_from_i32(0)), fact_of_types(a, y)).hi == 0;
}

// Whether d cannot be 0 if the comparison c is true.
static bool comparison_excludes_zero(const Analysis *a, Comparison c, const Expr *d)
{
    const bool unequal = c.op == SM_OP_LT || c.op == SM_OP_GT || c.op == SM_OP_NE;

    if (unequal && d->kind == EX_BINARY && d->op == SM_OP_SUB &&
        ((is_same_expr(a, c.a, d->arg[0]) && is_same_expr(a, c.b, d->arg[1])) ||
         (is_same_expr(a, c.a, d->arg[1]) && is_same_expr(a, c.b, d->arg[0]))))
        return true;
    return contradicts_zero(a, c.a, c.op, c.b, d) || contradicts_zero(a, c.b, comparison_swapped(c.op), c.a, d);
}

// Whether d cannot be 0 if the guard g is true (`holds`) or false.  g contains no `and`, `or` or `not`.
static bool simple_guard_excludes_zero(const Analysis *a, const Expr *g, bool holds, const Expr *d)
{
    if (g->kind == EX_CHAIN && !holds)
        return false;
    for (uint32_t i = 0; i < comparison_count(g); i++) {
        Comparison c = comparison_at(g, i);
        if (!holds)
            c.op = comparison_negated(c.op);
        if (comparison_excludes_zero(a, c, d))
            return true;
    }
    return comparison_count(g) != 1 && holds && is_same_expr(a, g, d);
}

// Returns 1 if e is never negative, -1 if it is never positive, 0 if neither is known.
static int known_sign_of(const Analysis *a, const Expr *e)
{
    const Fact f = fact_of_types(a, e);

    return f.lo >= 0 ? 1 : f.hi <= 0 ? -1 : 0;
}

// Whether d is a sum, difference or maximum that is 0 only if both operands are 0, because their signs are known.
static bool is_zero_only_with_both(const Analysis *a, const Expr *d)
{
    const bool is_sum = d->kind == EX_BINARY && d->op == SM_OP_ADD, is_difference = d->kind == EX_BINARY && d->op == SM_OP_SUB;
    int one, other;

    if (!is_sum && !is_difference && !is_call(d, SM_FN_max))
        return false;
    one = known_sign_of(a, d->arg[0]);
    other = known_sign_of(a, d->arg[1]);
    if (is_call(d, SM_FN_max))
        return one > 0 && other > 0;
    return one != 0 && other == (is_sum ? one : -one);
}

// Whether d cannot be 0 if the guard g is true (`holds`) or false: g excludes that d is 0, or that an operand of d is 0 which must be 0 for
// d to be 0.  g contains no `and`, `or` or `not`.
// Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX bounds.
static bool guard_excludes_zero_of_parts(const Analysis *a, const Expr *g, bool holds, const Expr *d)
{
    if (simple_guard_excludes_zero(a, g, holds, d))
        return true;
    if (d->kind == EX_UNARY && d->op == SM_OP_NEG)
        return guard_excludes_zero_of_parts(a, g, holds, d->arg[0]);
    return is_zero_only_with_both(a, d) &&
           (guard_excludes_zero_of_parts(a, g, holds, d->arg[0]) || guard_excludes_zero_of_parts(a, g, holds, d->arg[1]));
}

// Whether d cannot be 0 if the guard g is true (`holds`) or false.
static bool guard_excludes_zero(const Analysis *a, const Expr *g, bool holds, const Expr *d)
{
    if (g->kind == EX_UNARY && g->op == SM_OP_NOT)
        return guard_excludes_zero(a, g->arg[0], !holds, d);
    if (g->kind == EX_BINARY && (g->op == SM_OP_AND || g->op == SM_OP_OR)) {
        const bool one = guard_excludes_zero(a, g->arg[0], holds, d), other = guard_excludes_zero(a, g->arg[1], holds, d);
        return holds == (g->op == SM_OP_AND) ? one || other : one && other;
    }
    return guard_excludes_zero_of_parts(a, g, holds, d);
}

static bool reads_var(const Expr *e, const Var *v)
{
    if (e->kind == EX_VAR && e->var == v)
        return true;
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        if (reads_var(e->arg[i], v))
            return true;
    return false;
}

// Whether a known guard excludes that d is 0.  Ignores guards that read a variable which was assigned after their evaluation.
static bool some_guard_excludes_zero(const Analysis *a, const KnownGuard *known, const Expr *d)
{
    const Var *assigned[ENTRIES_MAX];
    size_t n = 0;

    for (size_t i = 0; known && i < ENTRIES_MAX; i++, known = known->outer) {
        bool stale = false;
        if (known->assigned)
            assigned[n++] = known->assigned->var;
        for (size_t v = 0; known->guard && v < n; v++)
            stale |= reads_var(known->guard, assigned[v]);
        if (known->guard && !stale && guard_excludes_zero(a, known->guard, known->holds, d))
            return true;
    }
    return false;
}

// Whether d cannot be 0 because its operands cannot be 0.
static bool operands_exclude_zero(const Analysis *a, const KnownGuard *known, const Expr *d)
{
    if (d->kind == EX_UNARY)
        return d->op == SM_OP_NEG && guards_exclude_zero(a, known, d->arg[0]);
    if (is_call(d, SM_FN_abs) || is_call(d, SM_FN_sqrt))
        return guards_exclude_zero(a, known, d->arg[0]);
    if (d->kind != EX_BINARY)
        return false;
    if (d->op == SM_OP_MUL)
        return guards_exclude_zero(a, known, d->arg[0]) && guards_exclude_zero(a, known, d->arg[1]);
    return d->op == SM_OP_DIV && guards_exclude_zero(a, known, d->arg[0]);
}

// Whether the types of the variables in d, and the known guards, prove that d is not 0.
bool guards_exclude_zero(const Analysis *a, const KnownGuard *known, const Expr *d)
{
    const Fact f = fact_of_types(a, d);

    return f.lo > 0 || f.hi < 0 || some_guard_excludes_zero(a, known, d) || operands_exclude_zero(a, known, d);
}
