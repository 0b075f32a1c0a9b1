// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_relate.h"

#include <string.h>

#include "compiler/ir/comparison.h"
#include "stdlib/math.h"

enum {
    DEPTH_MOST = 24,          // how deep the recursion follows the operands of an expression
    BUDGET = 400              // the most differences that are computed for one stored value or condition: expressions are DAGs, not trees
};

typedef struct Relation {
    const ProveModel *p;
    const ProveFlow *flow;
    const IrFn *f;
    const Fact *of;           // by temporary: what is known about it
    IrIns load;               // an extra temporary that no block contains: the load of a variable
    Fact loaded;              // what is known about the temporary `load`
    uint32_t *holder;         // by temporary: a variable that has its value now; or IR_NONE
    Fact now[PROVE_PAIRS];    // by pair: what is known about the difference at the current instruction
    Fact next[PROVE_PAIRS];   // the same after the store that is being followed
    unsigned budget;          // how many more differences can be computed
} Relation;

static Fact fact_between(double lo, double hi) { return (Fact){.lo = lo, .hi = hi, .minus_zero = true}; }
static Fact fact_of_any_number(void) { return fact_of_type(SM_F64); }
static bool is_whole(double x) { return x > -FACT_EXACT && x < FACT_EXACT && sm_trunc(x) == x; }

// Returns the numbers that agree with both facts.  If no number does, no run comes here, or the value is a NaN: then returns a.
static Fact intersect_facts(Fact a, Fact b)
{
    const Fact r = fact_between(a.lo > b.lo ? a.lo : b.lo, a.hi < b.hi ? a.hi : b.hi);

    return r.lo <= r.hi ? r : a;
}

static Fact negate_fact(Fact a) { return fact_between(-a.hi, -a.lo); }

// ---- bounds that round outward ----

static double add_rounding_down(double x, double y, double error)
{
    const double sum = x + y;

    if (sum != sum)
        return fact_of_any_number().lo;
    return error == 0 && is_whole(x) && is_whole(y) && is_whole(sum) ? sum : fact_next_below(fact_of_any_number(), sum - error);
}

static double add_rounding_up(double x, double y, double error) { return -add_rounding_down(-x, -y, error); }

Fact prove_difference(Fact a, Fact b)
{
    if (a.lo > a.hi || b.lo > b.hi)
        return fact_of_any_number();
    return fact_between(add_rounding_down(a.lo, -b.hi, 0), add_rounding_up(a.hi, -b.lo, 0));
}

// ---- differences of temporaries ----

static const IrIns *ins_of(const Relation *w, IrRef r) { return r == w->f->ins.n ? &w->load : &w->f->ins.at[r]; }
static const Fact *fact_of(const Relation *w, IrRef r) { return r == w->f->ins.n ? &w->loaded : &w->of[r]; }

// Whether comparisons and conversions to F64 have the exact value.  64-bit integers round.
static bool is_exact(const Relation *w, IrRef r)
{
    const SmType type = ins_of(w, r)->type;

    return sm_type_info[type].bytes < 8 || type == SM_F64;
}

static Fact find_difference(Relation *w, IrRef a, IrRef b, unsigned depth);

// Returns the pair of two variables; NULL: none.  *swapped: in the other order.
static Fact *find_pair(Relation *w, uint32_t x, uint32_t y, bool *swapped)
{
    for (uint32_t n = 0; n < w->p->pairs; n++) {
        const ProvePair *pair = &w->p->pair[n];
        *swapped = pair->x == y;
        if ((pair->x == x && pair->y == y) || (pair->x == y && pair->y == x))
            return &w->now[n];
    }
    return NULL;
}

// Whether temporary r can be NaN where temporary b is a number.
static bool may_be_nan(const Relation *w, IrRef r, IrRef b, unsigned depth)
{
    const IrIns *i = ins_of(w, r);

    if (!fact_of(w, r)->nan || r == b || (w->holder[r] != IR_NONE && w->holder[r] == w->holder[b]))
        return false;
    if (depth == 0 || (i->op != IR_min && i->op != IR_max && i->op != IR_abs && i->op != IR_neg))
        return true;
    return may_be_nan(w, i->a, b, depth - 1) || (i->b != IR_NONE && may_be_nan(w, i->b, b, depth - 1));
}

// Returns how far a rounded sum can be from the sum, with facts of which the bounds have at most this magnitude.  Sums of numbers near 0 are exact.
static double error_of_sum(Fact p, Fact q, double *reach)
{
    *reach = sm_max(sm_abs(p.lo), sm_abs(p.hi)) + sm_max(sm_abs(q.lo), sm_abs(q.hi));
    return p.whole && q.whole && *reach < FACT_EXACT ? 0 : *reach * 0x1p-51;
}

// Returns the bounds of (p + q) - b from those of p - b.
static Fact add_to_difference(Relation *w, IrRef p, Fact q, IrRef b, unsigned depth)
{
    double reach;
    const double error = error_of_sum(*fact_of(w, p), q, &reach);
    const Fact d = find_difference(w, p, b, depth);

    if (!(reach < 1e300))
        return fact_of_any_number();
    return fact_between(add_rounding_down(d.lo, q.lo, error), add_rounding_up(d.hi, q.hi, error));
}

// Returns the bounds of a - b that follow from how a is computed.
static Fact difference_by_operands(Relation *w, IrRef a, IrRef b, unsigned depth)
{
    const IrIns *i = ins_of(w, a);
    Fact of_a, of_b;

    if (i->op == IR_cvt && i->type == SM_F64)
        return is_exact(w, i->a) && !may_be_nan(w, i->a, b, depth) ? find_difference(w, i->a, b, depth) : fact_of_any_number();
    if ((i->op == IR_min || i->op == IR_max) && is_exact(w, i->a) && is_exact(w, i->b)) {
        of_a = find_difference(w, i->a, b, depth);
        of_b = find_difference(w, i->b, b, depth);
        return i->op == IR_min ? fact_between(sm_min(of_a.lo, of_b.lo), sm_min(of_a.hi, of_b.hi))
                               : fact_between(sm_max(of_a.lo, of_b.lo), sm_max(of_a.hi, of_b.hi));
    }
    if (i->type != SM_F64)
        return fact_of_any_number();
    if (i->op == IR_add)
        return intersect_facts(add_to_difference(w, i->a, *fact_of(w, i->b), b, depth), add_to_difference(w, i->b, *fact_of(w, i->a), b, depth));
    if (i->op == IR_sub) {
        of_b = *fact_of(w, i->b);
        of_a = fact_between(-of_b.hi, -of_b.lo);
        of_a.whole = of_b.whole;
        return add_to_difference(w, i->a, of_a, b, depth);
    }
    return fact_of_any_number();
}

// Returns the bounds of a - b.
static Fact find_difference(Relation *w, IrRef a, IrRef b, unsigned depth)
{
    const uint32_t x = w->holder[a], y = w->holder[b];
    bool swapped;
    const Fact *known;
    Fact d;

    if (a == b || (x != IR_NONE && x == y))
        return fact_between(0, 0);
    if (!is_exact(w, a) || !is_exact(w, b))
        return fact_of_any_number();
    d = prove_difference(*fact_of(w, a), *fact_of(w, b));
    known = x == IR_NONE || y == IR_NONE ? NULL : find_pair(w, x, y, &swapped);
    if (known)
        d = intersect_facts(d, swapped ? negate_fact(*known) : *known);
    if (depth == 0 || w->budget == 0)
        return d;
    w->budget--;
    d = intersect_facts(d, difference_by_operands(w, a, b, depth - 1));
    return intersect_facts(d, negate_fact(difference_by_operands(w, b, a, depth - 1)));
}

// ---- the block ----

// Returns a temporary of the block with the value that the variable has before instruction `at`: that of a load or of a store before, or one more load.
// IR_NONE: there is none.
static IrRef find_value(Relation *w, const IrBlk *b, uint32_t at, uint32_t var)
{
    const IrRef more = w->f->ins.n;
    bool is_stored = false;

    for (uint32_t k = 0; k < at; k++) {
        const IrRef r = b->ins.at[k];
        if (w->holder[r] == var)
            return r;
        is_stored |= ins_of(w, r)->op == IR_store && ins_of(w, r)->var == var;
    }
    if (is_stored)
        return IR_NONE;
    w->load = (IrIns){.op = IR_load, .type = w->p->ir->var.at[var].type, .a = IR_NONE, .b = IR_NONE, .var = var};
    w->loaded = env_get(w->flow->shape, w->flow->begin, var);
    w->holder[more] = var;
    return more;
}

// Returns the bounds of the difference of the value that instruction `at` of the block stores and a variable.
static Fact difference_of_stored(Relation *w, const IrBlk *b, uint32_t at, uint32_t other)
{
    const IrRef r = find_value(w, b, at, other);

    w->budget = BUDGET;
    return r == IR_NONE ? fact_of_any_number() : find_difference(w, ins_of(w, b->ins.at[at])->a, r, DEPTH_MOST);
}

// Stores a temporary in a variable: each difference of the variable is that of the temporary.
static void store_value(Relation *w, const IrBlk *b, uint32_t at)
{
    const IrIns *i = ins_of(w, b->ins.at[at]);

    for (uint32_t n = 0; n < w->p->pairs; n++) {
        const ProvePair *pair = &w->p->pair[n];
        if (pair->x == i->var)
            w->next[n] = difference_of_stored(w, b, at, pair->y);
        else
            w->next[n] = pair->y == i->var ? negate_fact(difference_of_stored(w, b, at, pair->x)) : w->now[n];
    }
    memcpy(w->now, w->next, sizeof w->now);
    for (uint32_t k = 0; k < at; k++)
        if (w->holder[b->ins.at[k]] == i->var)
            w->holder[b->ins.at[k]] = IR_NONE;
    w->holder[i->a] = i->var;
}

// ---- conditions ----

// Returns the fact about a comparison whose operands have this difference, if they are numbers.
static Fact compare_difference(IrOp op, Fact d, bool nan)
{
    const bool below = d.hi < 0, above = d.lo > 0, equal = d.lo == 0 && d.hi == 0;
    bool always, never;

    switch ((int)op) {
    case IR_lt: always = below, never = d.lo >= 0; break;
    case IR_le: always = d.hi <= 0, never = above; break;
    case IR_gt: always = above, never = d.hi <= 0; break;
    case IR_ge: always = d.lo >= 0, never = below; break;
    case IR_eq: always = equal, never = below || above; break;
    default: return fact_of_bool(!below && !above, nan || !equal);     // ne
    }
    return fact_of_bool(nan || !always, !never);
}

// Returns what is known about temporary r, also from the known differences of variables.
static Fact fact_by_differences(Relation *w, IrRef r, unsigned depth)
{
    const IrIns *i = ins_of(w, r);
    const unsigned operands = ir_op_info[i->op].operands;
    Fact a, b, now;

    if (depth == 0 || w->budget == 0 || operands == 0 || i->op == IR_store || i->op == IR_sample || i->op == IR_load || i->op == IR_stat)
        return *fact_of(w, r);
    w->budget--;
    a = fact_by_differences(w, i->a, depth - 1);
    b = operands == 2 ? fact_by_differences(w, i->b, depth - 1) : a;
    now = fact_meet(*fact_of(w, r), fact_of_result(i, &a, &b, ins_of(w, i->a)->type));
    if (i->op == IR_sub && i->type == SM_F64) {
        Fact d = find_difference(w, i->a, i->b, depth - 1);
        d.nan = true;
        now = fact_meet(now, d);
    }
    if (ir_is_comparison(i->op) && is_exact(w, i->a) && is_exact(w, i->b))
        now = fact_meet(now, compare_difference(i->op, find_difference(w, i->a, i->b, depth - 1), fact_of(w, i->a)->nan || fact_of(w, i->b)->nan));
    return now;
}

// Returns the variable that has the value of r, or of what r is converted from.
static uint32_t find_holder(const Relation *w, IrRef r)
{
    while (w->holder[r] == IR_NONE && ins_of(w, r)->op == IR_cvt && ins_of(w, r)->type == SM_F64 && is_exact(w, ins_of(w, r)->a)
           && !fact_of(w, ins_of(w, r)->a)->nan)
        r = ins_of(w, r)->a;
    return w->holder[r];
}

// Adds what follows from comparison i being true about the pair of its operands.
static void add_comparison(Relation *w, const IrIns *i, bool holds)
{
    const IrOp op = holds ? i->op : ir_negated_comparison(i->op);
    const double least = 0x1p-1074;           // the smallest difference of two different doubles
    const uint32_t x = find_holder(w, i->a), y = find_holder(w, i->b);
    bool swapped = false;
    Fact *known = x == IR_NONE || y == IR_NONE || !is_exact(w, i->a) || !is_exact(w, i->b) ? NULL : find_pair(w, x, y, &swapped);
    Fact d = fact_of_any_number();

    if (!known)
        return;
    if (op == IR_lt || op == IR_le || op == IR_eq)
        d.hi = op == IR_lt ? -least : 0;
    if (op == IR_gt || op == IR_ge || op == IR_eq)
        d.lo = op == IR_gt ? least : 0;
    *known = intersect_facts(*known, swapped ? negate_fact(d) : d);
}

// Adds what a condition that is true (`holds`) or false says about the differences of variables.
static void add_condition(Relation *w, IrRef r, bool holds, unsigned depth)
{
    const IrIns *i = ins_of(w, r);

    if (depth == 0)
        return;
    if (i->op == IR_not)
        add_condition(w, i->a, !holds, depth - 1);
    else if ((i->op == IR_and && holds) || (i->op == IR_or && !holds)) {
        add_condition(w, i->a, holds, depth - 1);
        add_condition(w, i->b, holds, depth - 1);
    } else if (ir_is_comparison(i->op))
        add_comparison(w, i, holds);
}

// Computes the differences at the end of the block.
static void run_block(Relation *w, const IrBlk *b)
{
    for (uint32_t n = 0; n < b->ins.n; n++)
        w->holder[b->ins.at[n]] = IR_NONE;
    for (uint32_t n = 0; n < b->ins.n; n++) {
        const IrRef r = b->ins.at[n];
        if (ins_of(w, r)->op == IR_load)
            w->holder[r] = ins_of(w, r)->var;
        else if (ins_of(w, r)->op == IR_store)
            store_value(w, b, n);
    }
}

bool prove_relate(const ProveFlow *flow, const Env **end)
{
    const ProveModel *p = flow->p;
    const IrBlk *b = &flow->f->blk.at[0];
    Relation w = {.p = p, .flow = flow, .f = flow->f, .of = flow->of, .holder = flow->holder};

    for (uint32_t n = 0; n < p->pairs; n++)
        w.now[n] = env_get(flow->shape, flow->begin, p->pair[n].var);
    run_block(&w, b);
    if (b->jump.kind == IR_BR) {
        w.budget = BUDGET;
        if (fact_by_differences(&w, b->jump.cond, DEPTH_MOST).hi < 1)
            return false;
        add_condition(&w, b->jump.cond, true, DEPTH_MOST);
    }
    for (uint32_t n = 0; n < p->pairs; n++)
        *end = env_set(flow->shape, *end, p->pair[n].var, w.now[n]);
    return true;
}
