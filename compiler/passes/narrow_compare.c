// SPDX-License-Identifier: Apache-2.0
// Part of `narrow`: moves comparisons to the type of their inputs.  A constant is replaced with the largest number of that type that does
// not exceed it, and the operator is changed so that the result is the same for every value.  Converting an I64 or U64 to F64 may round
// it, but preserves its order relative to every constant below 2^53, because numbers of that size are not rounded.  Two integers of one type
// that convert back to themselves are in the same order as their conversions: these are different where the integers are.
#include "compiler/ir/comparison.h"
#include "compiler/passes/narrow.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// Turns instruction ref into `a op b`.
static void replace_compare(Narrow *n, IrRef ref, IrOp op, IrRef a, IrRef b)
{
    IrIns *i = narrow_ins(n, ref);

    i->op = op;
    i->a = a;
    i->b = b;
}

// Replaces ref, a comparison of the bool `flag` with the constant c, with the bool itself, its negation, or a constant.
static void narrow_comparison_of_bool(Narrow *n, IrRef ref, IrOp op, IrRef flag, double c)
{
    const bool of_false = ir_compare(op, 0, c), of_true = ir_compare(op, 1, c);
    IrIns *i = narrow_ins(n, ref);

    if (of_true && !of_false) {
        n->same[ref] = flag;
        return;
    }
    i->op = of_false && !of_true ? IR_not : IR_const;
    i->a = i->op == IR_not ? flag : IR_NONE;
    i->b = IR_NONE;
    i->type = SM_BOOL;
    i->bits = of_true;
}

// Returns the operator for which comparing x with `below` has the same result as `x op c`.  c is not a number of x's type; `below` is the
// largest number of that type below c.
static IrOp op_for_lower_bound(IrOp op) { return op == IR_lt || op == IR_le ? IR_le : IR_gt; }

// Replaces `x op c` with a comparison of x with `below`, the largest number of x's type that is not above c.
static void compare_with_lower_bound(Narrow *n, IrRef ref, IrOp op, IrRef x, double c, double below)
{
    const SmType type = narrow_ins(n, x)->type;
    IrRef constant;

    if (below != c && ir_is_equality(op))
        return;
    constant = narrow_const(n, type, below, narrow_ins(n, ref)->span);
    replace_compare(n, ref, below == c ? op : op_for_lower_bound(op), x, constant);
}

static void narrow_comparison_of_integer(Narrow *n, IrRef ref, IrOp op, IrRef x, double c)
{
    const double below = sm_floor(c);
    const Fact type = fact_of_type(narrow_ins(n, x)->type);

    if (below >= type.lo && below <= type.hi && sm_abs(below) < FACT_EXACT)
        compare_with_lower_bound(n, ref, op, x, c, below);
}

static void narrow_comparison_of_f32(Narrow *n, IrRef ref, IrOp op, IrRef x, double c)
{
    const float near = sm_round_f32(c);
    double below = sm_from_f32(near);

    if (below > c) {
        const uint32_t u = sm_f32_bits(near);         // `near` is above c, so take the next smaller F32
        below = sm_from_f32(sm_f32_from_bits(below > 0 ? u - 1 : u + 1));
    }
    compare_with_lower_bound(n, ref, op, x, c, below);
}

// Replaces ref, which is `r op c` on F64, with a comparison in a narrower type, if r's number is available in one.
static void narrow_comparison_with_constant(Narrow *n, IrRef ref, IrOp op, IrRef r, double c)
{
    const IrRef x = n->narrow[r] != IR_NONE ? n->narrow[r] : n->wide[r];
    const SmType type = x == IR_NONE ? SM_F64 : narrow_ins(n, x)->type;

    if (type == SM_BOOL)
        narrow_comparison_of_bool(n, ref, op, x, c);
    else if (type == SM_F32)
        narrow_comparison_of_f32(n, ref, op, x, c);
    else if (type != SM_F64)
        narrow_comparison_of_integer(n, ref, op, x, c);
}

// Replaces a comparison of two F64 temporaries with one in a narrower type, if both numbers are available in a narrower type.
static void narrow_comparison_of_temporaries(Narrow *n, IrRef ref)
{
    const IrIns i = *narrow_ins(n, ref);
    IrRef a = n->narrow[i.a], b = n->narrow[i.b];

    if (narrow_same_round_trip(n, i.a, i.b)) {
        replace_compare(n, ref, i.op, n->wide[i.a], n->wide[i.b]);
        return;
    }
    if (a == IR_NONE || b == IR_NONE)
        return;
    if (narrow_ins(n, a)->type != narrow_ins(n, b)->type) {
        const SmType common = narrow_common_integer(n, IR_NONE, i.a, i.b);
        if (!narrow_has_integer(n, i.a) || !narrow_has_integer(n, i.b))
            return;
        a = narrow_get_integer(n, i.a, common);
        b = narrow_get_integer(n, i.b, common);
    }
    replace_compare(n, ref, i.op, a, b);
}

void narrow_compare(Narrow *n, IrRef ref)
{
    const IrIns i = *narrow_ins(n, ref);
    double c;

    if (narrow_ins(n, i.a)->type != SM_F64)
        return;
    if (narrow_is_const(n, i.b, &c))
        narrow_comparison_with_constant(n, ref, i.op, i.a, c);
    else if (narrow_is_const(n, i.a, &c))
        narrow_comparison_with_constant(n, ref, ir_swapped_comparison(i.op), i.b, c);
    else
        narrow_comparison_of_temporaries(n, ref);
}
