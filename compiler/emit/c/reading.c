// SPDX-License-Identifier: Apache-2.0
// Finds float elements that can be read without a NaN check.  A value that the function itself has stored is never NaN.  A NaN reads as 0.
// If a condition has the same result for NaN and 0, the difference is not visible: x > 775 is false for both.  So is 500 < x and x < 825,
// although 0 < 825.
#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"


// The load of a float element whose value, as an F32 or an F64, is r; or IR_NONE.
static IrRef read_by(const CFn *fn, IrRef r)
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
static bool is_as_nan(IrOp op, Fact y)
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
static IrRef reading_side(const CFn *fn, const IrIns *i)
{
    const IrRef a = read_by(fn, i->a), b = read_by(fn, i->b);

    return (a == IR_NONE) == (b == IR_NONE) ? IR_NONE : a != IR_NONE ? i->a : i->b;
}

static void note_compare(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    const IrRef x = reading_side(fn, i);
    CIns *c = &fn->ins[r];

    if (x != IR_NONE && soft_looks(fn, i, x)) {
        fn->ins[x].careless += c->uses > 0;
        return;
    }
    if (x == IR_NONE || !is_as_nan(x == i->a ? i->op : ir_swap_comparison(i->op), fn->ins[x == i->a ? i->b : i->a].fact))
        return;
    c->settled_by = read_by(fn, x);
    c->settled_value = i->op == IR_ne;
    fn->ins[x].careless += c->uses > 0;
}

// The other operand is settled if `load` reads NaN or 0, so the value of r does not matter then.  Excuses comparisons with `load` in r that
// have no other use.
static void excuse(CFn *fn, IrRef r, IrRef load)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];
    const IrRef x = ir_is_comparison(i->op) ? reading_side(fn, i) : IR_NONE;

    if (i->op == IR_const || c->uses != 1 || c->excused)
        return;
    if (x != IR_NONE && read_by(fn, x) == load && c->settled_by == IR_NONE) {
        c->excused = true;
        fn->ins[x].careless++;
    } else if (i->op == IR_and || i->op == IR_or || i->op == IR_not) {
        excuse(fn, i->a, load);
        if (i->b != IR_NONE)
            excuse(fn, i->b, load);
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
        if (c_is_const(fn, x) || by->settled_by == IR_NONE || by->settled_value != (i->op == IR_or))
            continue;
        excuse(fn, y, by->settled_by);
        c->settled_by = by->settled_by;
        c->settled_value = by->settled_value;
    }
}

static void note(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];

    c->settled_by = IR_NONE;
    if (i->op == IR_const)
        return;
    if (i->op == IR_sample) {
        fn->ins[i->a].careless += window_reads_nan(fn, i);
    } else if (ir_is_comparison(i->op)) {
        note_compare(fn, r);
    } else if (i->op == IR_and || i->op == IR_or) {
        note_logic(fn, r);
    } else if (i->op == IR_not && !c_is_const(fn, i->a)) {
        c->settled_by = fn->ins[i->a].settled_by;
        c->settled_value = !fn->ins[i->a].settled_value;
    }
}

// Blocks are visited in order, so a block's dominators have been visited before it.
static void note_stored(CFn *fn, uint32_t b, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CVarUse *w;

    if (i->op != IR_store && i->op != IR_load)
        return;
    w = &fn->var[i->var];
    if (w->stamp != fn->stamp)
        return;
    if (i->op == IR_load) {
        fn->ins[r].unchecked = read_by(fn, r) == r && w->settled && flow_dominates(&fn->flow, w->settled_at, b);
    } else if (!w->settled || !flow_dominates(&fn->flow, w->settled_at, b)) {
        w->settled = true;
        w->settled_at = b;
    }
}

void plan_readings(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++) {
        note_stored(fn, b, blk->ins.at[p]);
        note(fn, blk->ins.at[p]);
    }
    for (size_t p = blk->ins.n; p-- > 0;) {           // conversions before their operands
        const IrRef r = blk->ins.at[p], load = read_by(fn, r);
        CIns *c = &fn->ins[r];
        if (load == IR_NONE || c->uses == 0 || c->careless != c->uses)
            continue;
        if (load == r)
            c->unchecked = true;
        else
            fn->ins[load].careless++;
    }
}
