// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/guards_imply.h"

#include "stdlib/math.h"

enum { PAIRS_MAX = 64 };              // limit on the pairs of subexpressions compared in one query: `and` and `or` multiply them

typedef struct ImplySearch {
    const uint32_t *window_of;        // the machine's IrMachine.window_of, for expr_equal
    unsigned budget;                  // pairs of subexpressions that may still be compared
} ImplySearch;

// ---- comparisons ----

// One side of a comparison: the expression `base` plus the number `plus`, or `plus` alone.  Adding the same constant to two bases preserves their
// order, also after rounding.
typedef struct Side {
    const Expr *base;                 // NULL: the side is the number `plus`
    SmF64 plus;
} Side;

// The relation small < large; with `or_equal` small <= large.
typedef struct Order {
    Side small, large;
    bool or_equal;
} Order;

static bool is_finite(SmF64 x) { return sm_eq(sm_sub(x, x), sm_from_i32(0)); }

// Returns one side of a comparison as `base plus number`, so that `a + 2` and `a` can be compared.
static Side side_of(const Expr *e)
{
    Side s = {e, sm_from_i32(0)};

    if (expr_is_constant(e)) {
        s.plus = expr_constant_value(e);
        s.base = is_finite(s.plus) ? NULL : e;
    } else if (e->kind == EX_BINARY && (e->op == SM_OP_ADD || e->op == SM_OP_SUB) && expr_is_constant(e->arg[1])) {
        s.plus = expr_constant_value(e->arg[1]);
        s.base = is_finite(s.plus) ? e->arg[0] : e;
        if (e->op == SM_OP_SUB)
            s.plus = sm_neg(s.plus);
    }
    if (s.base == e)
        s.plus = sm_from_i32(0);
    return s;
}

// Whether p <= q is certain: both are the same base plus a constant, or both are numbers.
static bool is_at_most(const ImplySearch *k, const Side *p, const Side *q)
{
    const bool same_base = p->base && q->base ? expr_equal(p->base, q->base, k->window_of) : p->base == q->base;

    return same_base && sm_le(p->plus, q->plus);
}

// Whether p < q is certain: both are numbers.  If they had a base, rounding could make p and q equal.
static bool is_number_below(const Side *p, const Side *q) { return !p->base && !q->base && sm_lt(p->plus, q->plus); }

// Whether order a implies order b.  This is so if b.small <= a.small and a.large <= b.large.  If b is strict (<), one of these two
// relations, or a, must also be strict.
static bool order_implies(const ImplySearch *k, const Order *a, const Order *b)
{
    if (!is_at_most(k, &b->small, &a->small) || !is_at_most(k, &a->large, &b->large))
        return false;
    return b->or_equal || !a->or_equal || is_number_below(&b->small, &a->small) || is_number_below(&a->large, &b->large);
}

static Order order_of(const Expr *small, const Expr *large, bool or_equal)
{
    const Order o = {side_of(small), side_of(large), or_equal};

    return o;
}

// Returns the order of the two operands that c states if it is true: a <= b, or a < b.
static Order order_of_relation(const Comparison *c)
{
    const bool less = c->op == SM_OP_LT || c->op == SM_OP_LE;

    return order_of(less ? c->a : c->b, less ? c->b : c->a, c->op == SM_OP_LE || c->op == SM_OP_GE);
}

// Whether a comparison implies the order o.  An == implies two orders, a <= b and b <= a.
static bool comparison_implies_order(const ImplySearch *k, const Comparison *c, const Order *o)
{
    Order one, other;

    if (c->op == SM_OP_NE)
        return false;
    if (c->op != SM_OP_EQ) {
        one = order_of_relation(c);
        return order_implies(k, &one, o);
    }
    one = order_of(c->a, c->b, true);
    other = order_of(c->b, c->a, true);
    return order_implies(k, &one, o) || order_implies(k, &other, o);
}

// Whether comparison x implies comparison y.  If y is ==, x must imply both orders (a <= b and b <= a); if y is !=, one strict order.
static bool comparison_implies(const ImplySearch *k, const Comparison *x, const Comparison *y)
{
    Order one, other;

    if (y->op != SM_OP_EQ && y->op != SM_OP_NE) {
        one = order_of_relation(y);
        return comparison_implies_order(k, x, &one);
    }
    one = order_of(y->a, y->b, y->op == SM_OP_EQ);
    other = order_of(y->b, y->a, y->op == SM_OP_EQ);
    if (y->op == SM_OP_EQ)
        return comparison_implies_order(k, x, &one) && comparison_implies_order(k, x, &other);
    return comparison_implies_order(k, x, &one) || comparison_implies_order(k, x, &other);
}

// ---- guards ----

static bool is_logic(const Expr *e, SmOperator op) { return e->kind == EX_BINARY && e->op == op; }
static bool is_not(const Expr *e) { return e->kind == EX_UNARY && e->op == SM_OP_NOT; }

// Whether some comparison in the outermost node of x implies y.
static bool some_comparison_implies(ImplySearch *k, const Expr *x, const Comparison *y)
{
    for (uint32_t i = 0; i < comparison_count(x) && k->budget > 0; i++, k->budget--) {
        const Comparison c = comparison_at(x, i);
        if (comparison_implies(k, &c, y))
            return true;
    }
    return false;
}

// Whether y has comparisons in its outermost node, and those of x imply each of them.
static bool comparisons_imply(ImplySearch *k, const Expr *x, const Expr *y)
{
    for (uint32_t i = 0; i < comparison_count(y); i++) {
        const Comparison c = comparison_at(y, i);
        if (!some_comparison_implies(k, x, &c))
            return false;
    }
    return comparison_count(y) > 0;
}

// Whether y is true wherever x is true; false also if the search gives up.
static bool expr_implies(ImplySearch *k, const Expr *x, const Expr *y)
{
    if (k->budget == 0)
        return false;
    k->budget--;
    if (expr_equal(x, y, k->window_of))
        return true;
    if (is_logic(x, SM_OP_OR))
        return expr_implies(k, x->arg[0], y) && expr_implies(k, x->arg[1], y);
    if (is_logic(y, SM_OP_AND))
        return expr_implies(k, x, y->arg[0]) && expr_implies(k, x, y->arg[1]);
    if (is_logic(x, SM_OP_AND) && (expr_implies(k, x->arg[0], y) || expr_implies(k, x->arg[1], y)))
        return true;
    if (is_logic(y, SM_OP_OR))
        return expr_implies(k, x, y->arg[0]) || expr_implies(k, x, y->arg[1]);
    if (is_not(x) && is_not(y))
        return expr_implies(k, y->arg[0], x->arg[0]);
    return comparisons_imply(k, x, y);
}

// ---- contradictions ----

// Whether some comparison in x implies the negation of a comparison in y, so that x and y are never true together.  A true comparison has
// no NaN operand (except !=), so the negated operator is the exact opposite.
static bool comparisons_exclude(ImplySearch *k, const Expr *x, const Expr *y)
{
    for (uint32_t i = 0; i < comparison_count(y); i++) {
        Comparison c = comparison_at(y, i);
        c.op = comparison_negated(c.op);
        if (some_comparison_implies(k, x, &c))
            return true;
    }
    return false;
}

// Whether y is false wherever x is true; false also if the search gives up.
static bool expr_excludes(ImplySearch *k, const Expr *x, const Expr *y)
{
    if (k->budget == 0)
        return false;
    k->budget--;
    if (is_not(y))
        return expr_implies(k, x, y->arg[0]);
    if (is_not(x))
        return expr_implies(k, y, x->arg[0]);
    if (is_logic(x, SM_OP_OR))
        return expr_excludes(k, x->arg[0], y) && expr_excludes(k, x->arg[1], y);
    if (is_logic(y, SM_OP_OR))
        return expr_excludes(k, x, y->arg[0]) && expr_excludes(k, x, y->arg[1]);
    if (is_logic(x, SM_OP_AND))
        return expr_excludes(k, x->arg[0], y) || expr_excludes(k, x->arg[1], y);
    if (is_logic(y, SM_OP_AND))
        return expr_excludes(k, x, y->arg[0]) || expr_excludes(k, x, y->arg[1]);
    return comparisons_exclude(k, x, y) || comparisons_exclude(k, y, x);
}

// Variables and numbers are never NaN; computed values may be.
static bool is_never_nan(const Expr *e) { return e->kind == EX_VAR || e->kind == EX_NUMBER; }

// Whether `x or y` is always true, because one operand is true whenever the other is false.
static bool is_one_always_true(ImplySearch *k, const Expr *x, const Expr *y)
{
    Comparison a, b;

    if (is_not(x))
        return expr_implies(k, x->arg[0], y);
    if (is_not(y))
        return expr_implies(k, y->arg[0], x);
    if (x->kind == EX_CHAIN || y->kind == EX_CHAIN || !comparison_count(x) || !comparison_count(y))
        return false;
    a = comparison_at(x, 0);
    b = comparison_at(y, 0);
    a.op = comparison_negated(a.op);
    return is_never_nan(a.a) && is_never_nan(a.b) && comparison_implies(k, &a, &b);
}

// Whether e compares an expression with itself, as in x < x or x == x, and is therefore always true (`holds`) or never true.
static bool is_decided_by_equal_operands(const ImplySearch *k, const Expr *e, bool holds)
{
    if (e->kind != EX_BINARY || comparison_count(e) == 0 || !expr_equal(e->arg[0], e->arg[1], k->window_of))
        return false;
    if (holds)
        return is_never_nan(e->arg[0]) && (e->op == SM_OP_LE || e->op == SM_OP_GE || e->op == SM_OP_EQ);
    return e->op == SM_OP_LT || e->op == SM_OP_GT || (e->op == SM_OP_NE && is_never_nan(e->arg[0]));
}

static bool is_never_true(ImplySearch *k, const Expr *e);

static bool is_always_true(ImplySearch *k, const Expr *e)
{
    if (is_not(e))
        return is_never_true(k, e->arg[0]);
    if (is_logic(e, SM_OP_AND))
        return is_always_true(k, e->arg[0]) && is_always_true(k, e->arg[1]);
    if (is_logic(e, SM_OP_OR))
        return is_always_true(k, e->arg[0]) || is_always_true(k, e->arg[1]) || is_one_always_true(k, e->arg[0], e->arg[1]);
    return is_decided_by_equal_operands(k, e, true);
}

static bool is_never_true(ImplySearch *k, const Expr *e)
{
    if (is_not(e))
        return is_always_true(k, e->arg[0]);
    if (is_logic(e, SM_OP_OR))
        return is_never_true(k, e->arg[0]) && is_never_true(k, e->arg[1]);
    if (is_logic(e, SM_OP_AND))
        return is_never_true(k, e->arg[0]) || is_never_true(k, e->arg[1]) || expr_excludes(k, e->arg[0], e->arg[1]);
    return is_decided_by_equal_operands(k, e, false);
}

// ---- queries ----

// Whether y is true whenever x is, as long as no variable of y is assigned between their evaluations.  False means "not proved".
bool guard_implies(const Analysis *a, const Expr *x, const Expr *y)
{
    ImplySearch k = {a->m->window_of, PAIRS_MAX};

    return expr_implies(&k, x, y);
}

// Whether x and y are never true together.  False means "not proved".
bool guard_excludes(const Analysis *a, const Expr *x, const Expr *y)
{
    ImplySearch k = {a->m->window_of, PAIRS_MAX};

    return expr_excludes(&k, x, y);
}

// Whether x is never true (`a > b and a < b`), whatever its variables contain.  False means "not proved".
bool guard_is_never_true(const Analysis *a, const Expr *x)
{
    ImplySearch k = {a->m->window_of, PAIRS_MAX};

    return is_never_true(&k, x);
}

// Whether x is always true (`x <= x`), whatever its variables contain.  False means "not proved".
bool guard_is_always_true(const Analysis *a, const Expr *x)
{
    ImplySearch k = {a->m->window_of, PAIRS_MAX};

    return is_always_true(&k, x);
}
