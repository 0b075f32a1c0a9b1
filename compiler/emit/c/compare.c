// SPDX-License-Identifier: Apache-2.0
// Comparisons.  Both sides have the same type and are written in it.  If compilers would warn that a comparison is always true or always
// false, both sides are written as doubles, for which compilers cannot know that.
#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"
#include "stdlib/convert.h"

static void put(CFn *fn, const char *text) { buf_str(&fn->line, text); }

static const char *const compare_text[] = {
    [IR_eq - IR_eq] = " == ", [IR_ne - IR_eq] = " != ", [IR_lt - IR_eq] = " < ",
    [IR_le - IR_eq] = " <= ", [IR_gt - IR_eq] = " > ", [IR_ge - IR_eq] = " >= ",
};

// Whether two temporaries can produce the same C expression.
static bool is_same_text(const CFn *fn, IrRef a, IrRef b)
{
    const IrIns *x = c_ins(fn, a), *y = c_ins(fn, b);

    if (a == b)
        return true;
    if (c_is_const(fn, a) || c_is_const(fn, b))
        return c_is_const(fn, a) && c_is_const(fn, b) && c_ins(fn, a)->bits == c_ins(fn, b)->bits;
    if (x->op != y->op || x->type != y->type)
        return false;
    if (x->op == IR_load || x->op == IR_stat)
        return x->var == y->var && (x->op == IR_load || x->stat == y->stat);
    return is_same_text(fn, x->a, y->a) && (x->b == IR_NONE || is_same_text(fn, x->b, y->b));
}

// ---- integers ----

// Whether an integer type has values on both sides of the limit.
static bool is_undecided(const CFn *fn, IrOp op, IrRef limit, SmType t)
{
    const Fact r = fact_of_type(t);
    const double x = sm_cell_to_f64(c_ins(fn, limit)->type, c_ins(fn, limit)->bits);

    return x >= r.lo && x <= r.hi && !(x == r.lo && (op == IR_lt || op == IR_ge)) && !(x == r.hi && (op == IR_gt || op == IR_le));
}

// The type of the operand before C converts it.
static SmType source_type(const CFn *fn, IrRef r) { return c_ins(fn, is_widening(fn, r) ? c_ins(fn, r)->a : r)->type; }

static bool compares_integers(const CFn *fn, const IrIns *i)
{
    if (!c_is_integer(c_ins(fn, i->a)->type) || is_same_text(fn, i->a, i->b))
        return false;
    if (c_is_const(fn, i->a))
        return !c_is_const(fn, i->b) && is_undecided(fn, ir_swap_comparison(i->op), i->a, source_type(fn, i->b));
    return !c_is_const(fn, i->b) || is_undecided(fn, i->op, i->b, source_type(fn, i->a));
}

// ---- bools ----

static bool compares_bools(const CFn *fn, const IrIns *i)
{
    return ir_is_equality(i->op) && c_ins(fn, i->a)->type == SM_BOOL && !is_same_text(fn, i->a, i->b);
}

// ---- all types ----

static void put_sides(CFn *fn, const IrIns *i, const char *text)
{
    const SmType type = c_ins(fn, i->a)->type;
    const bool integers = compares_integers(fn, i), bools = compares_bools(fn, i);
    // C converts the shorter integer implicitly if the other side has the common type.
    const bool bare = integers && !(is_widening(fn, i->a) && is_widening(fn, i->b));

    for (int side = 0; side < 2; side++) {
        const IrRef r = side ? i->b : i->a;
        put(fn, side ? text : "");
        if (integers)
            put_value(fn, bare && is_widening(fn, r) ? c_ins(fn, r)->a : r, PREC_ADD);
        else if (bools || type == SM_F32)
            put_value(fn, r, bools ? PREC_PRIMARY : PREC_ADD);
        else
            put_double(fn, r, PREC_ADD);
    }
}

void put_compare(CFn *fn, const IrIns *i, bool negated, int prec)
{
    const bool equality = ir_is_equality(i->op), inverted = negated && !equality;
    const IrOp op = negated && equality ? ir_negate_comparison(i->op) : i->op;
    bool opened;

    if (fn->u->soft && soft_put_look(fn, i, negated))
        return;
    if (fn->u->soft && !compares_integers(fn, i) && !compares_bools(fn, i)) {
        soft_put_compare(fn, i, negated);
        return;
    }
    if (inverted)
        put(fn, "!");
    opened = open_parens(fn, equality ? PREC_EQ : PREC_REL, inverted ? PREC_PRIMARY : prec);
    put_sides(fn, i, compare_text[op - IR_eq]);
    close_parens(fn, opened);
}
