// SPDX-License-Identifier: Apache-2.0
// Facts within one function.  Control only moves forward, so one visit of the blocks in order is enough.  Each block begins with the
// facts that are true on every edge into it.
#include <string.h>

#include "compiler/facts/facts.h"
#include "compiler/ir/comparison.h"

enum { REFINEMENTS = 200 };           // conditions visited per branch: conditions that share operands form a DAG, not a tree

typedef struct Flow {
    FactMachine *fm;
    const IrFn *f;
    FactFlow out;
    const Env **begin;                // by block
    const Env *env;                   // at the current instruction
    uint32_t epoch;                   // of the current block
    FactHome *home;                   // by temporary
    unsigned budget;
    bool impossible;                  // the conditions of the edge being checked contradict the facts
} Flow;

static const IrIns *ins(const Flow *w, IrRef r) { return &w->f->ins.at[r]; }

// ---- forward ----

static void note_store(Flow *w, const IrIns *i, uint32_t at)
{
    Fact stored = w->out.of[i->a];

    stored.nan = false;
    w->env = env_set(&w->fm->shape, w->env, i->var, stored);
    w->fm->epoch[i->var] = w->epoch;
    w->fm->stored[i->var] = at;
}

static Fact fact_of(const Flow *w, const IrIns *i)
{
    static const Fact none;

    if (i->op == IR_load)
        return env_get(&w->fm->shape, w->env, i->var);
    if (i->op == IR_stat)
        return fact_of_stat(i->stat, w->fm->window[i->var]);
    return fact_of_result(i, i->a == IR_NONE ? &none : &w->out.of[i->a], i->b == IR_NONE ? &none : &w->out.of[i->b],
                          i->a == IR_NONE ? i->type : ins(w, i->a)->type);
}

static void note_home(Flow *w, IrRef r, uint32_t var, uint32_t at)
{
    w->home[r].var = var;
    w->home[r].at = at;
}

static void step_over(Flow *w, IrRef r, uint32_t at)
{
    const IrIns *i = ins(w, r);

    note_home(w, r, IR_NONE, at);
    if (i->op == IR_store) {
        note_store(w, i, at);
        note_home(w, i->a, i->var, at);
    } else if (i->op == IR_sample) {
        w->fm->window[i->var] = fact_convert(w->out.of[i->a], SM_F64);
    } else {
        w->out.of[r] = fact_of(w, i);
        if (i->op == IR_load)
            note_home(w, r, i->var, at);
    }
}

// ---- facts from a branch ----

// Whether the home of temporary r still holds r's value.
static bool is_home(const Flow *w, IrRef r)
{
    const FactHome h = w->home[r];

    return h.var != IR_NONE && (w->fm->epoch[h.var] != w->epoch || w->fm->stored[h.var] <= h.at);
}

// Bounds on a number that was converted from a 64-bit integer apply to the integer only where the conversion is exact.
static Fact before_conversion(Fact bounds, SmType type)
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

// Records that variable var is within bounds and not NaN.  If no value remains, the edge is impossible.  This proves that
// `p > 20 and p < 10` is always false, although neither half is.
static const Env *confine_var(Flow *w, const Env *env, uint32_t var, Fact bounds)
{
    const Fact known = env_get(&w->fm->shape, env, var);

    if (known.lo > bounds.hi || bounds.lo > known.hi)
        w->impossible = true;
    return env_set(&w->fm->shape, env, var, fact_meet(known, bounds));
}

// Records that r is within bounds, for its home variable and for the values from which r was converted.
static const Env *confine(Flow *w, const Env *env, IrRef r, Fact bounds)
{
    w->impossible |= bounds.lo > bounds.hi;
    for (;; r = ins(w, r)->a) {
        if (is_home(w, r))
            env = confine_var(w, env, w->home[r].var, bounds);
        if (ins(w, r)->op != IR_cvt || ins(w, r)->type != SM_F64 || w->out.of[ins(w, r)->a].nan)
            return env;
        bounds = before_conversion(bounds, ins(w, ins(w, r)->a)->type);
    }
}

typedef struct Pair { Fact a, b; } Pair;

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

static void refine_less(Fact *a, Fact *b, bool or_equal)
{
    const Fact was = *a;

    bound_above(a, or_equal ? b->hi : fact_below(*a, b->hi));
    bound_below(b, or_equal ? was.lo : fact_above(*b, was.lo));
}

static void refine_equal(Fact *a, Fact *b)
{
    refine_less(a, b, true);
    refine_less(b, a, true);
}

static void refine_unequal(Fact *a, const Fact *b)
{
    if (b->lo != b->hi)
        return;
    if (a->lo == b->lo)
        bound_below(a, fact_above(*a, a->lo));
    if (a->hi == b->lo)
        bound_above(a, fact_below(*a, a->hi));
}

static void refine_pair(Pair *p, IrOp op)
{
    switch ((int)op) {
    case IR_eq: refine_equal(&p->a, &p->b); break;
    case IR_ne: refine_unequal(&p->a, &p->b); refine_unequal(&p->b, &p->a); break;
    case IR_lt: refine_less(&p->a, &p->b, false); break;
    case IR_le: refine_less(&p->a, &p->b, true); break;
    case IR_gt: refine_less(&p->b, &p->a, false); break;
    case IR_ge: refine_less(&p->b, &p->a, true); break;
    }
}

// 64-bit integers are compared as F64.  Near 2^53 and beyond, a bound of one operand is not a bound of the other.
static bool is_exact(const Flow *w, IrRef r)
{
    const SmType type = ins(w, r)->type;

    return sm_type_info[type].bytes < 8 || type == SM_F64 || fact_within(w->out.of[r], -FACT_EXACT + 1, FACT_EXACT - 1);
}

static const Env *refine_compare(Flow *w, const Env *env, const IrIns *i, bool holds)
{
    Pair p = {w->out.of[i->a], w->out.of[i->b]};
    const bool nan = p.a.nan || p.b.nan;
    const bool a_exact = is_exact(w, i->a), b_exact = is_exact(w, i->b);

    if (p.a.lo > p.a.hi || p.b.lo > p.b.hi || (nan && holds != (i->op != IR_ne)))
        return env;
    if (!a_exact && !(b_exact && p.b.lo == p.b.hi))
        return env;
    if (!b_exact && !(a_exact && p.a.lo == p.a.hi))
        return env;
    refine_pair(&p, holds ? i->op : ir_negate_comparison(i->op));
    p.a.nan = p.b.nan = false;
    return confine(w, confine(w, env, i->a, p.a), i->b, p.b);
}

static const Env *refine(Flow *w, const Env *env, IrRef r, bool holds)
{
    const IrIns *i = ins(w, r);

    if (w->budget == 0)
        return env;
    w->budget--;
    if (i->op == IR_not)
        return refine(w, env, i->a, !holds);
    if ((i->op == IR_and && holds) || (i->op == IR_or && !holds))
        return refine(w, refine(w, env, i->a, holds), i->b, holds);
    if (ir_op_info[i->op].types == IR_T_COMPARE)
        return refine_compare(w, env, i, holds);
    return confine(w, env, r, fact_of_bool(!holds, holds));
}

// ---- blocks ----

static void go(Flow *w, IrBlkRef to, const Env *env)
{
    w->begin[to] = w->out.reached[to] ? env_join(&w->fm->shape, w->begin[to], env, NULL) : env;
    w->out.reached[to] = true;
}

// Follows the edge that is taken when the value of cond is `holds`.  Returns whether the facts allow that edge.
static bool take_way(Flow *w, IrRef cond, bool holds, IrBlkRef to)
{
    const Fact f = w->out.of[cond];
    const Env *env = w->env;

    if (holds ? f.hi < 1 : f.lo > 0)
        return false;
    w->budget = REFINEMENTS;
    w->impossible = false;
    env = refine(w, env, cond, holds);
    if (!w->impossible)
        go(w, to, env);
    return !w->impossible;
}

static void leave(Flow *w, const IrJump *j, FactExit *exit, const FactEnds *ends)
{
    exit->env = w->env;
    if (j->kind == IR_JMP) {
        go(w, j->then, w->env);
    } else if (j->kind == IR_BR) {
        exit->then = take_way(w, j->cond, true, j->then);
        exit->otherwise = take_way(w, j->cond, false, j->otherwise);
    } else if (ends) {
        ends->at(ends->context, j, w->env);
    }
}

// Uses the tables of the machine for this flow, because thousands of functions are analysed several times each.
static void take_tables(Flow *w)
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

static void look_at_block(Flow *w, const IrBlk *b, FactExit *exit, const FactEnds *ends)
{
    w->epoch = ++w->fm->epochs;
    for (uint32_t k = 0; k < b->ins.n; k++)
        step_over(w, b->ins.at[k], k);
    leave(w, &b->jump, exit, ends);
}

FactFlow facts_flow(FactMachine *fm, const IrFn *f, const Env *begin, const FactEnds *ends)
{
    Flow w = {.fm = fm, .f = f};

    take_tables(&w);
    go(&w, 0, begin);
    for (IrBlkRef b = 0; b < f->blk.n; b++)
        if (w.out.reached[b]) {
            w.env = w.begin[b];
            look_at_block(&w, &f->blk.at[b], &w.out.exit[b], ends);
        }
    return w.out;
}

FactFlow facts_of_function(FactMachine *fm, const IrFn *f, const Env *begin)
{
    return facts_flow(fm, f, begin, NULL);
}
