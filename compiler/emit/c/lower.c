// SPDX-License-Identifier: Apache-2.0
// Decides which temporaries of a function become part of the expressions that use them, and which become variables.  A temporary is inlined
// if it is used once and no store between its position and its use changes what it reads.  Expressions too deep for compilers are split.
// Also finds float loads that need no NaN check, and elements that are read once for the whole function.
#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"

enum { LEVEL_MAX = 40 };      // deeper expressions are split; clang's limit is 256 nested parentheses

// ---- facts ----

// In a block that is unreachable according to the facts, only the type restricts a value.
static Fact fact_of(const FactFlow *flow, size_t b, IrRef r, SmType type)
{
    Fact any = fact_of_type(type);

    any.nan = ir_is_float(type);
    return flow->reached[b] ? flow->of[r] : any;
}

void lower_find_facts(CFn *fn, const Env *begin)
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

static void count_use(CFn *fn, IrRef r)
{
    if (r != IR_NONE && !c_is_const(fn, r))
        fn->ins[r].uses++;
}

static CVarUse *var_use(CFn *fn, uint32_t v)
{
    CVarUse *w = &fn->var[v];

    if (w->stamp != fn->stamp) {
        w->loads = 0;
        w->stored = w->as_double = w->never_nan = false;
        w->copy = NULL;
        w->stamp = fn->stamp;
    }
    return w;
}

static void count_uses(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    if (c_is_branch(fn, b))
        count_use(fn, blk->jump.cond);
    for (size_t p = blk->ins.n; p-- > 0;) {
        const IrIns *i = &fn->f->ins.at[blk->ins.at[p]];
        const CIns *c = &fn->ins[blk->ins.at[p]];
        if (i->op == IR_store)
            var_use(fn, i->var)->stored = true;
        if (i->op == IR_load)
            var_use(fn, i->var)->loads += c->uses;
        if ((c->uses == 0 && !ir_op_info[i->op].effect) || i->op == IR_const)
            continue;
        count_use(fn, i->a);
        count_use(fn, i->b);
        if (i->op == IR_cvt && i->type == SM_F64)
            i = c_ins(fn, i->a);
        if (i->op == IR_load)
            var_use(fn, i->var)->as_double = true;
    }
}

// ---- loads that need no NaN check ----
// A value that the function itself has stored is never NaN.  A NaN reads as 0.  If a condition has the same result for NaN and 0, the
// difference is not visible: x > 775 is false for both.  So is 500 < x and x < 825, although 0 < 825.

// The load of a float element whose value, as an F32 or an F64, is r; or IR_NONE.
static IrRef load_of(const CFn *fn, IrRef r)
{
    const IrIns *i;

    if (r == IR_NONE || c_is_const(fn, r))
        return IR_NONE;
    i = c_ins(fn, r);
    if (i->op == IR_cvt && i->type == SM_F64 && c_ins(fn, i->a)->type == SM_F32)
        i = c_ins(fn, r = i->a);
    return i->op == IR_load && fn->u->m->var.at[i->var].space == IR_ELEMENT && sm_type_info[i->type].kind == SM_KIND_FLOAT ? r : IR_NONE;
}

// Whether 0 op y equals NaN op y for all y in a range.
static bool is_same_for_nan(IrOp op, Fact y)
{
    switch (op) {
    case IR_lt: return y.hi <= 0;
    case IR_le: return y.hi < 0;
    case IR_gt: return y.lo >= 0;
    case IR_ge: return y.lo > 0;
    case IR_eq: case IR_ne: return y.lo > 0 || y.hi < 0;
    default: return false;
    }
}

// The operand of a comparison that reads an element, if only one does; otherwise IR_NONE.
static IrRef element_side(const CFn *fn, const IrIns *i)
{
    const IrRef a = load_of(fn, i->a), b = load_of(fn, i->b);

    return (a == IR_NONE) == (b == IR_NONE) ? IR_NONE : a != IR_NONE ? i->a : i->b;
}

static void note_comparison(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    const IrRef x = element_side(fn, i);
    CIns *c = &fn->ins[r];

    if (x != IR_NONE && soft_compares_bytes(fn, i, x)) {
        fn->ins[x].nan_is_zero_uses += c->uses > 0;
        return;
    }
    if (x == IR_NONE || !is_same_for_nan(x == i->a ? i->op : ir_swapped_comparison(i->op), fn->ins[x == i->a ? i->b : i->a].fact))
        return;
    c->decided_by = load_of(fn, x);
    c->decided_value = i->op == IR_ne;
    fn->ins[x].nan_is_zero_uses += c->uses > 0;
}

// If `load` reads NaN or 0, the other operand decides the result and the value of r does not matter.  Masks comparisons with `load` in r that
// have no other use.
static void mask_comparisons(CFn *fn, IrRef r, IrRef load)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];
    const IrRef x = ir_is_comparison(i->op) ? element_side(fn, i) : IR_NONE;

    if (i->op == IR_const || c->uses != 1 || c->is_masked)
        return;
    if (x != IR_NONE && load_of(fn, x) == load && c->decided_by == IR_NONE) {
        c->is_masked = true;
        fn->ins[x].nan_is_zero_uses++;
    } else if (i->op == IR_and || i->op == IR_or || i->op == IR_not) {
        mask_comparisons(fn, i->a, load);
        if (i->b != IR_NONE)
            mask_comparisons(fn, i->b, load);
    }
}

// `and` is false if either operand is false, `or` is true if either is true, whatever the other operand is.
static void note_logic(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];

    for (int side = 0; side < 2; side++) {
        const IrRef x = side ? i->b : i->a, y = side ? i->a : i->b;
        const CIns *by = &fn->ins[x];
        if (c_is_const(fn, x) || by->decided_by == IR_NONE || by->decided_value != (i->op == IR_or))
            continue;
        mask_comparisons(fn, y, by->decided_by);
        c->decided_by = by->decided_by;
        c->decided_value = by->decided_value;
    }
}

static void note_instruction(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];

    c->decided_by = IR_NONE;
    if (i->op == IR_const)
        return;
    if (i->op == IR_sample) {
        fn->ins[i->a].nan_is_zero_uses += c_window_reads_nan(fn, i);
    } else if (ir_is_comparison(i->op)) {
        note_comparison(fn, r);
    } else if (i->op == IR_and || i->op == IR_or) {
        note_logic(fn, r);
    } else if (i->op == IR_not && !c_is_const(fn, i->a)) {
        c->decided_by = fn->ins[i->a].decided_by;
        c->decided_value = !fn->ins[i->a].decided_value;
    }
}

// Blocks are visited in order, so a block's dominators have been visited before it.
static void note_access(CFn *fn, uint32_t b, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CVarUse *w;

    if (i->op != IR_store && i->op != IR_load)
        return;
    w = &fn->var[i->var];
    if (w->stamp != fn->stamp)
        return;
    if (i->op == IR_load) {
        fn->ins[r].unchecked = load_of(fn, r) == r && w->never_nan && flow_dominates(&fn->flow, w->never_nan_from, b);
    } else if (!w->never_nan || !flow_dominates(&fn->flow, w->never_nan_from, b)) {
        w->never_nan = true;
        w->never_nan_from = b;
    }
}

// Finds the loads of a block that need no check, and takes them off the count of loads that do.  Uses have been counted.
static void find_unchecked_loads(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++) {
        note_access(fn, b, blk->ins.at[p]);
        note_instruction(fn, blk->ins.at[p]);
    }
    for (size_t p = blk->ins.n; p-- > 0;) {           // conversions before their operands
        const IrRef r = blk->ins.at[p], load = load_of(fn, r);
        CIns *c = &fn->ins[r];
        if (load == IR_NONE || c->uses == 0 || c->nan_is_zero_uses != c->uses)
            continue;
        if (load == r)
            c->unchecked = true;
        else
            fn->ins[load].nan_is_zero_uses++;
    }
    for (size_t p = 0; p < blk->ins.n; p++) {
        const CIns *c = &fn->ins[blk->ins.at[p]];
        if (c->unchecked)
            var_use(fn, c_ins(fn, blk->ins.at[p])->var)->loads -= c->uses;
    }
}

// ---- elements that are read once for the whole function ----

// Reading a float needs a check for NaN, and T a subtraction.
static bool is_computed(const CFn *fn, uint32_t v)
{
    const IrVar *var = &fn->u->m->var.at[v];

    return (var->space == IR_TIME && !fn->u->soft) || (var->space == IR_ELEMENT && ir_is_float(var->type));
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
        w->copy = c_copy_name(fn, i->var);
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

// Whether the conversion is to a wider integer, of a U8 to a bool, or of an unsigned integer to a float of at least its size.  C compilers
// share these.
static bool is_cheap_conversion(SmType to, SmType from)
{
    if (ir_is_float(to) || to == SM_BOOL)
        return sm_type_info[from].kind == SM_KIND_UNSIGNED && sm_type_info[to].bytes >= sm_type_info[from].bytes;
    return ir_is_integer(from) && ir_integer_contains(to, from);
}

// Whether repeating it costs nothing: a plain member, or a cheap conversion of one.
static bool is_plain(CFn *fn, const IrIns *i, const CIns *c)
{
    const IrIns *from = i->op == IR_cvt ? &fn->f->ins.at[i->a] : i;

    if (i->op == IR_cvt)
        return from->op == IR_load && is_cheap_conversion(i->type, from->type) && !is_computed(fn, from->var);
    return i->op == IR_load && (!is_computed(fn, i->var) || c->unchecked || var_use(fn, i->var)->copy);
}

static CForm form(CFn *fn, const IrIns *i, const CIns *c)
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

static void place_instructions(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    fn->block = ++*fn->block_stamps;
    if (c_is_branch(fn, b))
        place_operand(fn, blk->jump.cond, (uint32_t)blk->ins.n, 1);
    for (size_t p = blk->ins.n; p-- > 0;) {
        const IrRef r = blk->ins.at[p];
        const IrIns *i = &fn->f->ins.at[r];
        CIns *c = &fn->ins[r];
        c->form = form(fn, i, c);
        if (c->form != C_DEAD) {
            const bool own = c->form != C_INLINE;      // it is its own statement
            place_operand(fn, i->a, own ? (uint32_t)p : c->latest, own ? 1 : c->level + 1);
            place_operand(fn, i->b, own ? (uint32_t)p : c->latest, own ? 1 : c->level + 1);
        }
        note_store(fn, i, (uint32_t)p);
    }
}

void lower_function(CFn *fn)
{
    const uint32_t end = fn->flow.n - 1;

    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            count_uses(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            find_unchecked_loads(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            choose_copies(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            place_instructions(fn, b);
}
