// SPDX-License-Identifier: Apache-2.0
// Facts within one function.  Control only moves forward, so one visit of the blocks in order is enough.  Each block begins with the
// facts that are true on every edge into it.
#include <string.h>

#include "compiler/facts/facts.h"
#include "compiler/ir/comparison.h"

enum { REFINEMENTS = 200 };           // conditions visited per branch: conditions that share operands form a DAG, not a tree

typedef struct FlowWalk {
    FactMachine *fm;
    const IrFn *f;
    FactFlow out;
    const Env **begin;                // by block: the facts at its beginning
    const Env *env;                   // the facts at the current instruction
    uint32_t epoch;                   // number of the current block visit (FactMachine.epochs)
    FactHome *home;                   // by temporary: a variable with the same value
    unsigned budget;                  // how many conditions may still be visited for this branch
    bool contradicts;                 // the conditions of the edge being checked contradict the facts: it is never taken
} FlowWalk;

static const IrIns *ins(const FlowWalk *w, IrRef r) { return &w->f->ins.at[r]; }

// ---- instructions ----

// Computes the fact of temporary r, or applies the effect of a store or sample.  `at`: the instruction's position in its block.
static void visit_ins(FlowWalk *w, IrRef r, uint32_t at)
{
    static const Fact none;
    const IrIns *i = ins(w, r);

    w->home[r] = (FactHome){i->op == IR_load ? i->var : IR_NONE, at};
    if (i->op == IR_store) {
        Fact stored = w->out.of[i->a];
        stored.nan = false;
        w->env = env_set(&w->fm->shape, w->env, i->var, stored);
        w->fm->epoch[i->var] = w->epoch;
        w->fm->stored[i->var] = at;
        w->home[i->a] = (FactHome){i->var, at};
    } else if (i->op == IR_sample) {
        w->fm->window[i->var] = fact_convert(w->out.of[i->a], SM_F64);
    } else if (i->op == IR_load) {
        w->out.of[r] = env_get(&w->fm->shape, w->env, i->var);
    } else if (i->op == IR_stat) {
        w->out.of[r] = fact_of_stat(i->stat, w->fm->window[i->var]);
    } else {
        const Fact *a = i->a == IR_NONE ? &none : &w->out.of[i->a], *b = i->b == IR_NONE ? &none : &w->out.of[i->b];
        w->out.of[r] = fact_of_result(i, a, b, i->a == IR_NONE ? i->type : ins(w, i->a)->type);
    }
}

// ---- facts from a branch ----

// Whether temporary r has a home (FactHome) that still contains r's value: no later store in this block has changed it.
static bool has_home(const FlowWalk *w, IrRef r)
{
    const FactHome h = w->home[r];

    return h.var != IR_NONE && (w->fm->epoch[h.var] != w->epoch || w->fm->stored[h.var] <= h.at);
}

// Converts bounds of an F64 that was converted from a value of this type to bounds of that value.  For a 64-bit integer, a bound is kept
// only where the conversion is exact.
static Fact bounds_before_conversion(Fact bounds, SmType type)
{
    if (sm_type_info[type].bytes == 8 && type != SM_F64) {
        const Fact t = fact_of_type(type);
        if (!(bounds.lo > -FACT_EXACT && bounds.lo < FACT_EXACT))
            bounds.lo = t.lo;
        if (!(bounds.hi > -FACT_EXACT && bounds.hi < FACT_EXACT))
            bounds.hi = t.hi;
    }
    return bounds;
}

// Returns env with the added fact that r is within bounds and not NaN, for the home variable (FactHome) of r and of the values from which r
// was converted.  Sets w->contradicts if no value remains: so `p > 20 and p < 10` is found to be always false, although neither half is.
static const Env *refine_value(FlowWalk *w, const Env *env, IrRef r, Fact bounds)
{
    w->contradicts |= bounds.lo > bounds.hi;
    for (;; r = ins(w, r)->a) {
        if (has_home(w, r)) {
            const uint32_t var = w->home[r].var;
            const Fact known = env_get(&w->fm->shape, env, var);
            w->contradicts |= known.lo > bounds.hi || bounds.lo > known.hi;
            env = env_set(&w->fm->shape, env, var, fact_meet(known, bounds));
        }
        if (ins(w, r)->op != IR_cvt || ins(w, r)->type != SM_F64 || w->out.of[ins(w, r)->a].nan)
            return env;
        bounds = bounds_before_conversion(bounds, ins(w, ins(w, r)->a)->type);
    }
}

static void bound_above(Fact *a, double hi)
{
    if (hi < a->hi)
        a->hi = hi;
}

static void bound_below(Fact *a, double lo)
{
    if (lo > a->lo)
        a->lo = lo;
}

// Narrows both facts to the values for which *a < *b, or *a <= *b.
static void bound_by_less(Fact *a, Fact *b, bool or_equal)
{
    const Fact was = *a;

    bound_above(a, or_equal ? b->hi : fact_next_below(*a, b->hi));
    bound_below(b, or_equal ? was.lo : fact_next_above(*b, was.lo));
}

// Excludes b from *a, if b is exactly one number and a bound of *a.
static void bound_by_unequal(Fact *a, const Fact *b)
{
    if (b->lo != b->hi)
        return;
    if (a->lo == b->lo)
        bound_below(a, fact_next_above(*a, a->lo));
    if (a->hi == b->lo)
        bound_above(a, fact_next_below(*a, a->hi));
}

// Narrows the facts of both operands to the values for which `*a op *b` is true.
static void bound_by_comparison(Fact *a, IrOp op, Fact *b)
{
    switch ((int)op) {
    case IR_eq: bound_by_less(a, b, true); bound_by_less(b, a, true); break;
    case IR_ne: bound_by_unequal(a, b); bound_by_unequal(b, a); break;
    case IR_lt: bound_by_less(a, b, false); break;
    case IR_le: bound_by_less(a, b, true); break;
    case IR_gt: bound_by_less(b, a, false); break;
    case IR_ge: bound_by_less(b, a, true); break;
    }
}

// Whether a comparison compares the exact value of r.  It converts 64-bit integers to F64, which rounds from 2^53 on.  If an operand is
// rounded, a bound of one operand does not follow from a bound of the other.
static bool is_compared_exactly(const FlowWalk *w, IrRef r)
{
    const SmType type = ins(w, r)->type;

    return sm_type_info[type].bytes < 8 || type == SM_F64 || fact_within(w->out.of[r], -FACT_EXACT + 1, FACT_EXACT - 1);
}

// Returns env, narrowed to the case that the comparison i is true (`holds`) or false; env itself if nothing follows from that.
static const Env *refine_comparison(FlowWalk *w, const Env *env, const IrIns *i, bool holds)
{
    Fact a = w->out.of[i->a], b = w->out.of[i->b];
    const bool nan = a.nan || b.nan;
    const bool a_exact = is_compared_exactly(w, i->a), b_exact = is_compared_exactly(w, i->b);

    if (a.lo > a.hi || b.lo > b.hi || (nan && holds != (i->op != IR_ne)))
        return env;
    if (!a_exact && !(b_exact && b.lo == b.hi))
        return env;
    if (!b_exact && !(a_exact && a.lo == a.hi))
        return env;
    bound_by_comparison(&a, holds ? i->op : ir_negated_comparison(i->op), &b);
    a.nan = b.nan = false;
    return refine_value(w, refine_value(w, env, i->a, a), i->b, b);
}

// Returns env, narrowed to the case that condition r is true (`holds`) or false.
static const Env *refine_by_condition(FlowWalk *w, const Env *env, IrRef r, bool holds)
{
    const IrIns *i = ins(w, r);

    if (w->budget == 0)
        return env;
    w->budget--;
    if (i->op == IR_not)
        return refine_by_condition(w, env, i->a, !holds);
    if ((i->op == IR_and && holds) || (i->op == IR_or && !holds))
        return refine_by_condition(w, refine_by_condition(w, env, i->a, holds), i->b, holds);
    if (ir_op_info[i->op].types == IR_T_COMPARE)
        return refine_comparison(w, env, i, holds);
    return refine_value(w, env, r, fact_of_bool(!holds, holds));
}

// ---- blocks ----

// Merges the facts `env` of an edge to block `to` into the facts at the beginning of that block.
static void join_at_block(FlowWalk *w, IrBlkRef to, const Env *env)
{
    w->begin[to] = w->out.reached[to] ? env_join(&w->fm->shape, w->begin[to], env, NULL) : env;
    w->out.reached[to] = true;
}

// Follows the edge to block `to` that is taken if cond is true (`holds`) or false.  Returns whether the facts allow that edge.
static bool follow_edge(FlowWalk *w, IrRef cond, bool holds, IrBlkRef to)
{
    const Fact f = w->out.of[cond];
    const Env *env = w->env;

    if (holds ? f.hi < 1 : f.lo > 0)
        return false;
    w->budget = REFINEMENTS;
    w->contradicts = false;
    env = refine_by_condition(w, env, cond, holds);
    if (!w->contradicts)
        join_at_block(w, to, env);
    return !w->contradicts;
}

static void visit_block(FlowWalk *w, IrBlkRef b, const FactEnds *ends)
{
    const IrBlk *block = &w->f->blk.at[b];
    const IrJump *j = &block->jump;
    FactExit *exit = &w->out.exit[b];

    w->env = w->begin[b];
    w->epoch = ++w->fm->epochs;
    for (uint32_t k = 0; k < block->ins.n; k++)
        visit_ins(w, block->ins.at[k], k);
    exit->env = w->env;
    if (j->kind == IR_JMP) {
        join_at_block(w, j->then, w->env);
    } else if (j->kind == IR_BR) {
        exit->then = follow_edge(w, j->cond, true, j->then);
        exit->otherwise = follow_edge(w, j->cond, false, j->otherwise);
    } else if (ends) {
        ends->visit(ends->context, j, w->env);
    }
}

// Lets w use the tables of the machine (FactMachine), after growing them if the function needs larger ones.  The tables are used again
// for each function, because thousands of functions are analysed several times each.
static void reuse_tables(FlowWalk *w)
{
    FactMachine *fm = w->fm;
    Arena *arena = fm->shape.arena;

    if (w->f->ins.n > fm->temps) {
        fm->temps = w->f->ins.n * 2;
        fm->of = ARENA_ARRAY(arena, Fact, fm->temps);
        fm->home = ARENA_ARRAY(arena, FactHome, fm->temps);
    }
    if (w->f->blk.n > fm->blocks) {
        fm->blocks = w->f->blk.n * 2;
        fm->reached = ARENA_ARRAY(arena, bool, fm->blocks);
        fm->exit = ARENA_ARRAY(arena, FactExit, fm->blocks);
        fm->block_begin = ARENA_ARRAY(arena, const Env *, fm->blocks);
    }
    memset(fm->reached, 0, w->f->blk.n * sizeof *fm->reached);
    w->out.of = fm->of;
    w->out.reached = fm->reached;
    w->out.exit = fm->exit;
    w->home = fm->home;
    w->begin = fm->block_begin;
}

FactFlow facts_flow(FactMachine *fm, const IrFn *f, const Env *begin, const FactEnds *ends)
{
    FlowWalk w = {.fm = fm, .f = f};

    reuse_tables(&w);
    join_at_block(&w, 0, begin);
    for (IrBlkRef b = 0; b < f->blk.n; b++)
        if (w.out.reached[b])
            visit_block(&w, b, ends);
    return w.out;
}

FactFlow facts_of_function(FactMachine *fm, const IrFn *f, const Env *begin)
{
    return facts_flow(fm, f, begin, NULL);
}
