// SPDX-License-Identifier: Apache-2.0
// Part of `identity`: replaces an operation by a cheaper one that produces the same bits for all operands.  The proof is next to each
// rule.  The sign and payload of a NaN are not observable (language.md 2).
//
// x / 2^k is exactly x * 2^-k, but is not replaced.  The VM encodes 8 in an operand and needs eight more bytes for 0.125, and C
// compilers know this rule.
#include "compiler/ir/comparison.h"
#include "compiler/ir/eval.h"
#include "compiler/passes/identity.h"

static void replace_op(IrIns *i, IrOp op, IrRef a, IrRef b)
{
    i->op = op;
    i->a = a;
    i->b = b;
}

static void replace_by_bool(IrIns *i, bool value)
{
    replace_op(i, IR_const, IR_NONE, IR_NONE);
    i->bits = value;
}

static bool is_op(const Identity *d, IrRef ref, IrOp op) { return identity_at(d, ref)->op == op; }

// Returns the first operand of the instruction that computes ref.
static IrRef operand_of(const Identity *d, IrRef ref) { return identity_at(d, ref)->a; }

static bool is_negation(const Identity *d, IrRef ref) { return is_op(d, ref, IR_neg); }

// Replaces the addition of a negated operand by a subtraction, and the reverse.  IEEE 754 defines a - b as a + (-b), and addition commutes.
// On integers both forms are exact (ir.h), and no -0 exists that they could treat differently.
static void rewrite_sum(const Identity *d, IrIns *i)
{
    if (is_negation(d, i->b))                                 // a + -b becomes a - b; a - -b becomes a + b
        replace_op(i, i->op == IR_add ? IR_sub : IR_add, i->a, operand_of(d, i->b));
    else if (i->op == IR_add && is_negation(d, i->a))         // -a + b becomes b - a
        replace_op(i, IR_sub, i->b, operand_of(d, i->a));
}

// Removes the negations if both operands of a product or quotient are negated; returns false if not.  The signs of the operands determine
// only the sign of the result, and two negations do not change that sign.
static bool try_cancel_negations(const Identity *d, IrIns *i)
{
    if (!is_negation(d, i->a) || !is_negation(d, i->b))
        return false;
    replace_op(i, i->op, operand_of(d, i->a), operand_of(d, i->b));
    return true;
}

// Cancels two negations; otherwise replaces a multiplication by -1 with a negation: both change only the sign.
static void rewrite_product(const Identity *d, IrIns *i)
{
    if (try_cancel_negations(d, i))
        return;
    if (identity_is_const(d, i->b, sm_from_i32(-1)))
        replace_op(i, IR_neg, i->a, IR_NONE);
    else if (identity_is_const(d, i->a, sm_from_i32(-1)))
        replace_op(i, IR_neg, i->b, IR_NONE);
}

// ---- comparisons ----

// Replaces `not` of a comparison with the opposite comparison.  lt, le, gt and ge have an opposite only if no operand can be NaN: with a
// NaN, `a < b` and `a >= b` are both false.
static void rewrite_not(const Identity *d, IrIns *i)
{
    const IrIns *from = identity_at(d, i->a);

    if (ir_is_comparison(from->op) && (ir_is_equality(from->op) || (d->never_nan[from->a] && d->never_nan[from->b])))
        replace_op(i, ir_negated_comparison(from->op), from->a, from->b);
}

// Simplifies a comparison of a bool, or of a number converted from a bool, with a constant.  The result depends only on whether the bool
// is true: it is a constant, the bool or its negation.  Returns false if i is no such comparison.
static bool try_rewrite_bool_comparison(const Identity *d, IrIns *i)
{
    const bool swap = identity_at(d, i->b)->op != IR_const;
    const IrIns *constant = identity_at(d, swap ? i->a : i->b);
    const IrOp op = swap ? ir_swapped_comparison(i->op) : i->op;
    IrRef boolean = swap ? i->b : i->a;
    bool if_false, if_true;           // the result of the comparison if the bool is false; if it is true
    SmF64 number;

    if (is_op(d, boolean, IR_cvt) && identity_at(d, boolean)->type != SM_BOOL)
        boolean = operand_of(d, boolean);
    if (identity_at(d, boolean)->type != SM_BOOL || constant->op != IR_const)
        return false;
    number = ir_number(constant->type, constant->bits);
    if_false = ir_compare(op, sm_from_i32(0), number);
    if_true = ir_compare(op, sm_from_i32(1), number);
    if (if_false == if_true)
        replace_by_bool(i, if_false);
    else if (if_false)
        replace_op(i, IR_not, boolean, IR_NONE);
    else
        replace_op(i, IR_and, boolean, boolean);              // find_equal_operand (identity.c) then replaces `b and b` by b
    return true;
}

static void rewrite_comparison(const Identity *d, IrIns *i)
{
    const bool true_if_equal = i->op == IR_eq || i->op == IR_le || i->op == IR_ge;

    if (try_rewrite_bool_comparison(d, i) || i->a != i->b)
        return;
    if (i->op == IR_lt || i->op == IR_gt || d->never_nan[i->a])       // x < x and x > x are false even if x is NaN
        replace_by_bool(i, true_if_equal);
}

// ---- conversions ----

// Bypasses the operation that produces the operand of a conversion, if the result of the conversion is the same without it.
static void rewrite_cvt(const Identity *d, IrIns *i)
{
    const IrIns *from = identity_at(d, i->a);

    if (i->type != SM_F64 && from->op == IR_cvt && from->type == SM_F64 && identity_at(d, from->a)->type == SM_F64)
        i->a = from->a;                                       // NaN becomes 0 or false either way
    else if (from->op == IR_trunc && identity_is_integer(i->type))
        i->a = from->a;                                       // a conversion to an integer already truncates
    else if ((from->op == IR_neg || from->op == IR_abs) && i->type == SM_BOOL)
        i->a = from->a;                                       // whether a number is zero does not depend on its sign
}

// Replaces i with a cheaper operation that has the same result, if there is one.
void identity_rewrite_cheaper(const Identity *d, IrIns *i)
{
    switch (i->op) {
    case IR_add:
    case IR_sub: rewrite_sum(d, i); break;
    case IR_mul: rewrite_product(d, i); break;
    case IR_div: try_cancel_negations(d, i); break;
    case IR_abs:
        if (is_negation(d, i->a) || is_op(d, i->a, IR_abs))
            i->a = operand_of(d, i->a);
        break;
    case IR_not: rewrite_not(d, i); break;
    case IR_cvt: rewrite_cvt(d, i); break;
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: rewrite_comparison(d, i); break;
    default: break;
    }
}
