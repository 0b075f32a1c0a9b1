// SPDX-License-Identifier: Apache-2.0
// Conditions of ways: made of expressions, and decided.  Comparisons become bounds on sums, so that `p > limit + 2` and
// `p < limit - 2` meet.  A NaN is not reckoned with: both would fail then, and neither transition be made.
#include "compiler/analysis/way_formula.h"

#include "stdlib/math.h"

// ---- making ----

static const WayFormula always = {.kind = WAY_ALWAYS}, never = {.kind = WAY_NEVER};

const WayFormula *way_never(void) { return &never; }

static const WayFormula *of_two(Way *w, WayKind kind, const WayFormula *a, const WayFormula *b)
{
    const WayKind rules = kind == WAY_AND ? WAY_NEVER : WAY_ALWAYS, yields = kind == WAY_AND ? WAY_ALWAYS : WAY_NEVER;
    WayFormula *f;

    if (a->kind == rules || b->kind == yields)
        return a;
    if (b->kind == rules || a->kind == yields)
        return b;
    f = ARENA_NEW(w->a->arena, WayFormula);
    f->kind = kind;
    f->a = a;
    f->b = b;
    return f;
}

const WayFormula *way_or(Way *w, const WayFormula *a, const WayFormula *b) { return of_two(w, WAY_OR, a, b); }

static bool compare(double x, SmOperator op, double y)
{
    switch ((int)op) {
    case SM_OP_LT: return x < y;
    case SM_OP_LE: return x <= y;
    case SM_OP_GT: return x > y;
    case SM_OP_GE: return x >= y;
    case SM_OP_EQ: return x == y;
    default: return x != y;
    }
}

// sum op 0, with the first term taken once and the number on the other side.
static const WayFormula *bound(Way *w, WaySum s, SmOperator op)
{
    WayFormula *f;
    double first;

    if (s.n == 0)
        return compare(s.constant, op, 0) ? &always : &never;
    f = ARENA_NEW(w->a->arena, WayFormula);
    first = s.term[0].times;
    f->kind = WAY_BOUND;
    f->op = first < 0 ? relation_mirrored(op) : op;
    f->limit = -s.constant / first;
    for (unsigned i = 0; i < s.n; i++)
        s.term[i].times /= first;
    s.constant = 0;
    f->sum = s;
    return f;
}

static const WayFormula *relation(Way *w, const Expr *a, SmOperator op, const Expr *b, bool holds)
{
    WaySum x = way_sum(w, a), y = way_sum(w, b);

    if (!way_subtract(&x, &y))
        x = way_unknown(w, false);
    return bound(w, x, holds ? op : relation_opposite(op));
}

static const WayFormula *chain(Way *w, const Expr *e, bool holds)
{
    const WayFormula *f = holds ? &always : &never;

    for (uint32_t i = 0; i + 1 < e->n; i++)
        f = of_two(w, holds ? WAY_AND : WAY_OR, f, relation(w, e->arg[i], expr_ops(e)[i], e->arg[i + 1], holds));
    return f;
}

static const WayFormula *not_zero(Way *w, const Expr *e, bool holds)
{
    const WayValue *now = e->kind == EX_VAR ? way_assigned(w, e->var) : NULL;

    if (now && now->yes)
        return holds ? now->yes : now->no;
    return bound(w, way_sum(w, e), holds ? SM_OP_NE : SM_OP_EQ);
}

static const WayFormula *binary(Way *w, const Expr *e, bool holds)
{
    switch ((int)sm_op_info[e->op].op_class) {
    case SM_CLASS_LOGIC:
        return of_two(w, (e->op == SM_OP_AND) == holds ? WAY_AND : WAY_OR, way_formula(w, e->arg[0], holds),
                      way_formula(w, e->arg[1], holds));
    case SM_CLASS_RELATION:
    case SM_CLASS_EQUALITY:
        return relation(w, e->arg[0], e->op, e->arg[1], holds);
    }
    return not_zero(w, e, holds);
}

// As deep as the tree: AST_DEPTH_MAX bounds it.
const WayFormula *way_formula(Way *w, const Expr *e, bool holds)
{
    switch (e->kind) {
    case EX_UNARY:  return e->op == SM_OP_NOT ? way_formula(w, e->arg[0], !holds) : not_zero(w, e, holds);
    case EX_BINARY: return binary(w, e, holds);
    case EX_CHAIN:  return chain(w, e, holds);
    case EX_NUMBER: case EX_VAR: case EX_CALL: case EX_ROLL: break;
    }
    return not_zero(w, e, holds);
}

// ---- deciding ----

enum { SUMS = 24, BUDGET = 400, NOTS = 2 };

// What is known of one sum: it lies between lo and hi, which belong to it unless they are open.
typedef struct Known {
    WaySum sum;
    double lo, hi, not[NOTS];
    bool lo_open, hi_open;
    unsigned nots;
} Known;

typedef struct Decision {
    const Way *w;
    unsigned budget;
    size_t n;
    Known known[SUMS];
} Decision;

typedef struct Rest Rest;
struct Rest { const WayFormula *f; const Rest *then; };

static Known known_at_first(const Way *w, const WaySum *s)
{
    Known k = {.sum = *s, .lo = fact_of_type(SM_F64).lo, .hi = fact_of_type(SM_F64).hi};

    if (s->n == 1) {
        k.lo = w->atom.at[s->term[0].atom].fact.lo;
        k.hi = w->atom.at[s->term[0].atom].fact.hi;
    }
    return k;
}

static bool same_sum(const WaySum *a, const WaySum *b)
{
    for (unsigned i = 0; a->n == b->n && i < a->n; i++)
        if (a->term[i].atom != b->term[i].atom || a->term[i].times != b->term[i].times)
            return false;
    return a->n == b->n;
}

static Known *known_of(Decision *d, const WaySum *s)
{
    for (size_t i = 0; i < d->n; i++)
        if (same_sum(&d->known[i].sum, s))
            return &d->known[i];
    if (d->n == SUMS)
        return NULL;
    d->known[d->n] = known_at_first(d->w, s);
    return &d->known[d->n++];
}

static void at_least(Known *k, double x, bool open)
{
    if (x > k->lo || (x == k->lo && open)) {
        k->lo = x;
        k->lo_open = open;
    }
}

static void at_most(Known *k, double x, bool open)
{
    if (x < k->hi || (x == k->hi && open)) {
        k->hi = x;
        k->hi_open = open;
    }
}

static void apart_from(Known *k, double x)
{
    if (x == k->lo)
        at_least(k, x, true);
    if (x == k->hi)
        at_most(k, x, true);
    if (k->nots < NOTS)
        k->not[k->nots++] = x;
}

static double round_up(double x) { return sm_trunc(x) + (x > sm_trunc(x)); }

// Of whole numbers an open end is the next one further in.
static void close_ends(const Way *w, Known *k)
{
    if (!way_sum_is_whole(w, &k->sum) || k->lo < -FACT_EXACT || k->hi > FACT_EXACT)
        return;
    k->lo = round_up(k->lo) + (k->lo_open && k->lo == round_up(k->lo));
    k->hi = -round_up(-k->hi) - (k->hi_open && k->hi == -round_up(-k->hi));
    k->lo_open = k->hi_open = false;
}

static bool leaves_something(const Known *k)
{
    if (k->lo > k->hi || (k->lo == k->hi && (k->lo_open || k->hi_open)))
        return false;
    for (unsigned i = 0; k->lo == k->hi && i < k->nots; i++)
        if (k->not[i] == k->lo)
            return false;
    return true;
}

static bool confine(Decision *d, const WayFormula *f)
{
    Known *k = known_of(d, &f->sum);

    if (!k)
        return true;
    switch ((int)f->op) {
    case SM_OP_LT: at_most(k, f->limit, true); break;
    case SM_OP_LE: at_most(k, f->limit, false); break;
    case SM_OP_GT: at_least(k, f->limit, true); break;
    case SM_OP_GE: at_least(k, f->limit, false); break;
    case SM_OP_EQ: at_least(k, f->limit, false); at_most(k, f->limit, false); break;
    default: apart_from(k, f->limit); break;
    }
    close_ends(d->w, k);
    return leaves_something(k);
}

static bool can_hold(Decision *d, const WayFormula *f, const Rest *rest);

static bool either(Decision *d, const WayFormula *f, const Rest *rest)
{
    const Decision before = *d;
    unsigned left;

    if (can_hold(d, f->a, rest))
        return true;
    left = d->budget;
    *d = before;
    d->budget = left;
    return can_hold(d, f->b, rest);
}

// Whether f and all of the rest can hold.  As deep as there are conditions, which the budget bounds.
static bool can_hold(Decision *d, const WayFormula *f, const Rest *rest)
{
    if (d->budget == 0)
        return true;
    d->budget--;
    if (f->kind == WAY_NEVER)
        return false;
    if (f->kind == WAY_OR)
        return either(d, f, rest);
    if (f->kind == WAY_AND) {
        const Rest then = {f->b, rest};
        return can_hold(d, f->a, &then);
    }
    if (f->kind == WAY_BOUND && !confine(d, f))
        return false;
    return !rest || can_hold(d, rest->f, rest->then);
}

bool way_decide(const Way *w, const WayFormula *also)
{
    Decision d = {.w = w, .budget = BUDGET};
    Rest *all = ARENA_ARRAY(w->a->arena, Rest, w->demand.n + 1);
    const Rest *list = NULL;

    if (also) {
        all[w->demand.n] = (Rest){also, NULL};
        list = &all[w->demand.n];
    }
    for (size_t i = w->demand.n; i-- > 0; list = &all[i])
        all[i] = (Rest){w->demand.at[i], list};
    return !list || can_hold(&d, list->f, list->then);
}
