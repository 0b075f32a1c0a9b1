// SPDX-License-Identifier: Apache-2.0
// Decides which temporaries of a function become part of the expressions that use them, and which become variables.  A temporary is inlined
// if it is used once and no store between its position and its use changes what it reads.  Expressions too deep for compilers are split.
// Also finds elements that are read once for the whole function.
#include "compiler/emit/c/fn.h"

enum { LEVEL_MAX = 40 };      // deeper expressions are split; clang's limit is 256 nested parentheses

static bool is_float(SmType t) { return t == SM_F64 || t == SM_F32; }

// ---- facts ----

// In a block that is unreachable according to the facts, only the type restricts a value.
static Fact fact_of(const FactFlow *flow, size_t b, IrRef r, SmType type)
{
    Fact any = fact_of_type(type);

    any.nan = is_float(type);
    return flow->reached[b] ? flow->of[r] : any;
}

void plan_facts(CFn *fn, const Env *begin)
{
    const IrFn *f = fn->f;
    const FactFlow flow = facts_of_function(fn->u->facts, f, begin);

    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++) {
            const IrRef r = f->blk.at[b].ins.at[p];
            fn->ins[r].fact = fact_of(&flow, b, r, f->ins.at[r].type);
        }
}

// ---- which instructions are needed, and how often ----

static void use(CFn *fn, IrRef r)
{
    if (r != IR_NONE && !c_is_const(fn, r))
        fn->ins[r].uses++;
}

static CVarUse *var_use(CFn *fn, uint32_t v)
{
    CVarUse *w = &fn->var[v];

    if (w->stamp != fn->stamp) {
        w->loads = 0;
        w->stored = w->as_double = w->settled = false;
        w->copy = NULL;
        w->stamp = fn->stamp;
    }
    return w;
}

static bool has_two_ways(const CFn *fn, uint32_t b) { return fn->flow.other[b] != IR_NONE; }

static void note_double(CFn *fn, const IrIns *i)
{
    const IrIns *a = i->op == IR_cvt && i->type == SM_F64 ? &fn->f->ins.at[i->a] : i;

    if (a->op == IR_load)
        var_use(fn, a->var)->as_double = true;
}

static void count_uses(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    if (has_two_ways(fn, b))
        use(fn, blk->jump.cond);
    for (size_t p = blk->ins.n; p-- > 0;) {
        const IrIns *i = &fn->f->ins.at[blk->ins.at[p]];
        const CIns *c = &fn->ins[blk->ins.at[p]];
        if (i->op == IR_store)
            var_use(fn, i->var)->stored = true;
        if (i->op == IR_load)
            var_use(fn, i->var)->loads += c->uses;
        if ((c->uses == 0 && !ir_op_info[i->op].effect) || i->op == IR_const)
            continue;
        use(fn, i->a);
        use(fn, i->b);
        note_double(fn, i);
    }
}

static void settle_readings(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    plan_readings(fn, b);
    for (size_t p = 0; p < blk->ins.n; p++) {
        const CIns *c = &fn->ins[blk->ins.at[p]];
        if (c->unchecked)
            var_use(fn, fn->f->ins.at[blk->ins.at[p]].var)->loads -= c->uses;
    }
}

// ---- elements that are read once for the whole function ----

// Reading a float needs a check for NaN, and T a subtraction.
static bool is_computed(const CFn *fn, uint32_t v)
{
    const IrVar *var = &fn->u->m->var.at[v];

    return (var->space == IR_TIME && !fn->u->soft) || (var->space == IR_ELEMENT && is_float(var->type));
}

static void choose_copies(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++) {
        const IrIns *i = &fn->f->ins.at[blk->ins.at[p]];
        CVarUse *w;
        if (i->op != IR_load || !is_computed(fn, i->var))
            continue;
        w = var_use(fn, i->var);
        if (fn->ins[blk->ins.at[p]].unchecked || w->copy || w->stored || w->loads < 2)
            continue;
        w->copy = copy_name(fn, i->var);
        w->copy_type = i->type == SM_F32 && w->as_double ? SM_F64 : i->type;
        vec_push(fn->u->arena, &fn->copied, i->var);
    }
}

// ---- the position of each temporary ----

static uint32_t later(uint32_t a, uint32_t b) { return a > b ? a : b; }

static void place_operand(CFn *fn, IrRef r, uint32_t at, uint32_t level)
{
    if (r == IR_NONE)
        return;
    fn->ins[r].latest = later(fn->ins[r].latest, at);
    fn->ins[r].level = later(fn->ins[r].level, level);
}

static uint32_t next_store(CFn *fn, const IrIns *i)
{
    if (i->op == IR_load)
        return var_use(fn, i->var)->block_stamp == fn->block ? fn->var[i->var].next_store : UINT32_MAX;
    return i->op == IR_stat ? fn->window_sample[i->var] : UINT32_MAX;
}

// Whether repeating it costs nothing: a plain member, or one converted to a wider integer.
static bool is_plain(CFn *fn, const IrIns *i, const CIns *c)
{
    const IrIns *from = i->op == IR_cvt ? &fn->f->ins.at[i->a] : i;

    if (i->op == IR_cvt)
        return from->op == IR_load && c_is_integer(from->type) && c_holds_all(i->type, from->type) && !is_computed(fn, from->var);
    return i->op == IR_load && (!is_computed(fn, i->var) || c->unchecked || var_use(fn, i->var)->copy);
}

static CHow how(CFn *fn, const IrIns *i, const CIns *c)
{
    if (ir_op_info[i->op].effect)
        return C_EFFECT;
    if (c->uses == 0 || i->op == IR_const)
        return C_DEAD;
    if (next_store(fn, i) < c->latest)
        return C_VARIABLE;
    if (is_plain(fn, i, c))
        return C_INLINE;
    return c->uses > 1 || c->level > LEVEL_MAX ? C_VARIABLE : C_INLINE;
}

static void note_store(CFn *fn, const IrIns *i, uint32_t at)
{
    if (i->op == IR_store) {
        fn->var[i->var].block_stamp = fn->block;
        fn->var[i->var].next_store = at;
    } else if (i->op == IR_sample) {
        fn->window_sample[i->var] = at;
    }
}

static void place(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    fn->block = ++*fn->block_stamps;
    if (has_two_ways(fn, b))
        place_operand(fn, blk->jump.cond, (uint32_t)blk->ins.n, 1);
    for (size_t p = blk->ins.n; p-- > 0;) {
        const IrRef r = blk->ins.at[p];
        const IrIns *i = &fn->f->ins.at[r];
        CIns *c = &fn->ins[r];
        c->how = how(fn, i, c);
        if (c->how != C_DEAD) {
            const bool own = c->how != C_INLINE;      // it is its own statement
            place_operand(fn, i->a, own ? (uint32_t)p : c->latest, own ? 1 : c->level + 1);
            place_operand(fn, i->b, own ? (uint32_t)p : c->latest, own ? 1 : c->level + 1);
        }
        note_store(fn, i, (uint32_t)p);
    }
}

void plan_function(CFn *fn)
{
    const uint32_t end = fn->flow.n - 1;

    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            count_uses(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            settle_readings(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            choose_copies(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            place(fn, b);
}
