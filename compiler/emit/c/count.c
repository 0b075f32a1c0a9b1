// SPDX-License-Identifier: Apache-2.0
// Counters and sums of 64 bits.  The stored value is exact up to 2^53 and rounded above that, where counting by one ends.  No IR operation
// on integers expresses this; a function of stdlib does, which checks at run time.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"


// A counter and its increment: a constant, or the conversion of an integer or a boolean.
typedef struct CCounter {
    IrRef v, by;
    IrRef truth;              // it counts by one if this is true; or IR_NONE
    bool down;
} CCounter;

// The integer that r, inlined, converts to F64; or IR_NONE.
static IrRef integer_of(const CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);

    return !c_is_const(fn, r) && fn->ins[r].form == C_INLINE && i->op == IR_cvt && ir_is_integer(c_ins(fn, i->a)->type) ? i->a : IR_NONE;
}

// The boolean that r, inlined, converts to F64; or IR_NONE.
static IrRef truth_of(const CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);

    return !c_is_const(fn, r) && fn->ins[r].form == C_INLINE && i->op == IR_cvt && c_ins(fn, i->a)->type == SM_BOOL ? i->a : IR_NONE;
}

static bool is_step(const CFn *fn, IrRef r)
{
    const Fact x = fn->ins[r].fact;

    if (truth_of(fn, r) != IR_NONE)
        return true;
    return x.whole && fact_within(x, -FACT_EXACT / 2, FACT_EXACT / 2) && (c_is_const(fn, r) ? x.lo != 0 : integer_of(fn, r) != IR_NONE);
}

static bool is_counted(const CFn *fn, IrRef r, SmType to)
{
    return integer_of(fn, r) != IR_NONE && c_ins(fn, integer_of(fn, r))->type == to;
}

// Whether r is an inlined F64 `v + n` or `v - n`.
static bool find_count(const CFn *fn, IrRef r, SmType to, CCounter *c)
{
    const IrIns *i = c_ins(fn, r);
    const bool swap = i->op == IR_add && !is_counted(fn, i->a, to);

    if ((i->op != IR_add && i->op != IR_sub) || i->type != SM_F64 || fn->ins[r].form != C_INLINE)
        return false;
    c->v = swap ? i->b : i->a;
    c->by = swap ? i->a : i->b;
    c->down = i->op == IR_sub;
    c->truth = truth_of(fn, c->by);
    return is_counted(fn, c->v, to) && is_step(fn, c->by);
}

static bool is_up_by_one(const CFn *fn, const CCounter *c, SmType to)
{
    double by;
    const bool by_one = c->truth != IR_NONE || (fact_is_number(fn->ins[c->by].fact, &by) && by == 1);

    return to == SM_U64 && !c->down && by_one && fact_within(fn->ins[c->v].fact, 0, FACT_EXACT);
}

// Writes the increment argument of a helper; `up`: the helper counts up by one.
static void write_step(CFn *fn, const CCounter *c, bool up)
{
    const IrRef n = integer_of(fn, c->by);
    const double x = fn->ins[c->by].fact.lo;

    if (up && c->truth == IR_NONE)
        return;
    c_write(fn, ", ");
    if (c->truth != IR_NONE) {
        c_write_condition(fn, c->truth, false, up ? PREC_ANY : PREC_OR);
        c_write(fn, up ? "" : c->down ? " ? -1 : 0" : " ? 1 : 0");
    } else if (c_is_const(fn, c->by)) {
        c_write_constant(fn, c->by, SM_I64, sm_cell_from_f64(SM_I64, c->down ? -x : x));
    } else if (c->down || c_ins(fn, n)->type == SM_U64) {
        c_write(fn, c->down ? "-(int64_t)" : "(int64_t)");
        c_write_value(fn, n, PREC_PRIMARY);
    } else {
        c_write_assigned(fn, n);
    }
}

bool soft_write_count(CFn *fn, const IrIns *store)
{
    const IrIns *i = c_ins(fn, store->a);
    IrRef v;
    CCounter c;

    if (!fn->u->soft || i->op != IR_cvt || i->type != SM_U64 || c_is_const(fn, store->a) || fn->ins[store->a].form != C_INLINE ||
        c_ins(fn, i->a)->type != SM_F64 || !find_count(fn, i->a, SM_U64, &c) || c.truth != IR_NONE ||
        !is_up_by_one(fn, &c, SM_U64))
        return false;
    v = integer_of(fn, c.v);
    if (c_ins(fn, v)->op != IR_load || c_ins(fn, v)->var != store->var || fn->ins[v].form != C_INLINE)
        return false;
    c_write(fn, "sm_soft_increment(&");
    c_write_cell(fn, store->var);
    c_write(fn, ")");
    return true;
}

static const char *helper_of(CFn *fn, const CCounter *c, SmType to)
{
    if (!is_up_by_one(fn, c, to))
        return to == SM_U64 ? "sm_count_u64" : "sm_count_i64";
    return c->truth == IR_NONE ? "sm_count_up" : "sm_count_up_if";
}

bool c_write_count(CFn *fn, IrRef r, SmType to)
{
    CCounter c;

    if ((to != SM_U64 && to != SM_I64) || !find_count(fn, r, to, &c))
        return false;
    c_write(fn, helper_use(fn->u, helper_of(fn, &c, to)));
    c_write(fn, "(");
    c_write_value(fn, integer_of(fn, c.v), PREC_ANY);
    write_step(fn, &c, is_up_by_one(fn, &c, to));
    c_write(fn, ")");
    return true;
}
