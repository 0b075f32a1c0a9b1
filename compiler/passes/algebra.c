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

// The first operand of the instruction that computes ref.
static IrRef operand_of(const Identity *d, IrRef ref) { return identity_at(d, ref)->a; }

static bool is_negation(const Identity *d, IrRef ref) { return is_op(d, ref, IR_neg); }

// IEEE 754 defines a - b as a + (-b), and addition commutes.  An integer result has no -0.
static void rewrite_sum(const Identity *d, IrIns *i)
{
    if (is_negation(d, i->b))                                 // a + -b, a - -b
        replace_op(i, i->op == IR_add ? IR_sub : IR_add, i->a, operand_of(d, i->b));
    else if (i->op == IR_add && is_negation(d, i->a))         // -a + b
        replace_op(i, IR_sub, i->b, operand_of(d, i->a));
}

// -a * -b is a * b, and -a / -b is a / b: the signs of the operands only determine the sign of the result.  Returns false if the rule
// does not apply.
static bool try_cancel_negations(const Identity *d, IrIns *i)
{
    if (!is_negation(d, i->a) || !is_negation(d, i->b))
        return false;
    replace_op(i, i->op, operand_of(d, i->a), operand_of(d, i->b));
    return true;
}

static void rewrite_product(const Identity *d, IrIns *i)
{
    if (try_cancel_negations(d, i))
        return;
    if (identity_is_const(d, i->b, sm_from_i32(-1)))          // exact: only the sign changes
        replace_op(i, IR_neg, i->a, IR_NONE);
    else if (identity_is_const(d, i->a, sm_from_i32(-1)))
        replace_op(i, IR_neg, i->b, IR_NONE);
}

// ---- comparisons ----

// Whether i is a comparison that can be negated.  lt, le, gt and ge cannot if an operand may be NaN: both are false then.
static bool is_negatable(const Identity *d, const IrIns *i)
{
    if (!ir_is_comparison(i->op))
        return false;
    return ir_is_equality(i->op) || (d->never_nan[i->a] && d->never_nan[i->b]);
}

static void rewrite_not(const Identity *d, IrIns *i)
{
    const IrIns *from = identity_at(d, i->a);

    if (is_negatable(d, from))
        replace_op(i, ir_negated_comparison(from->op), from->a, from->b);
}

// Simplifies `boolean op number`, where boolean is 0 or 1, to false, true, `not boolean` or `boolean`.  The last becomes `boolean and
// boolean`, which find_equal_operand (identity.c) then replaces by its operand.
static void compare_bool_to_number(IrIns *i, IrOp op, IrRef boolean, SmF64 number)
{
    const bool of_false = ir_compare(op, sm_from_i32(0), number), of_true = ir_compare(op, sm_from_i32(1), number);

    if (of_false == of_true)
        replace_by_bool(i, of_false);
    else if (of_false)
        replace_op(i, IR_not, boolean, IR_NONE);
    else
        replace_op(i, IR_and, boolean, boolean);
}

// Returns ref if it is a bool, or the bool that ref is converted from; IR_NONE if ref is neither.
static IrRef skip_bool_cvt(const Identity *d, IrRef ref)
{
    const IrIns *i = identity_at(d, ref);

    if (i->type == SM_BOOL)
        return ref;
    return i->op == IR_cvt && identity_at(d, i->a)->type == SM_BOOL ? i->a : IR_NONE;
}

// Simplifies a comparison of a bool with a constant.  Returns false if i is not one.
static bool try_rewrite_bool_comparison(const Identity *d, IrIns *i)
{
    const bool swap = identity_at(d, i->b)->op != IR_const;
    const IrIns *constant = identity_at(d, swap ? i->a : i->b);
    const IrRef boolean = skip_bool_cvt(d, swap ? i->b : i->a);

    if (boolean == IR_NONE || constant->op != IR_const)
        return false;
    compare_bool_to_number(i, swap ? ir_swapped_comparison(i->op) : i->op, boolean, ir_number(constant->type, constant->bits));
    return true;
}

static void rewrite_comparison(const Identity *d, IrIns *i)
{
    bool true_if_equal = i->op == IR_eq || i->op == IR_le || i->op == IR_ge;

    if (try_rewrite_bool_comparison(d, i) || i->a != i->b)
        return;
    if (i->op == IR_lt || i->op == IR_gt || d->never_nan[i->a])       // x < x is false for NaN too
        replace_by_bool(i, true_if_equal);
}

// ---- conversions ----

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
