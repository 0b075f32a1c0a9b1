// SPDX-License-Identifier: Apache-2.0
// The six comparison operations of the IR: their classes, swapped and negated forms, and results.
#ifndef SMC_IR_COMPARISON_H
#define SMC_IR_COMPARISON_H

#include "compiler/ir/ir.h"
#include "stdlib/f64.h"

static inline bool ir_is_comparison(IrOp op) { return ir_op_info[op].types == IR_T_COMPARE; }

// Whether op is eq or ne.  Both have the same result with the operands exchanged, and can be negated even if an operand is NaN.
static inline bool ir_is_equality(IrOp op) { return op == IR_eq || op == IR_ne; }

// Returns the comparison for exchanged operands: `a op b` equals `b ir_swapped_comparison(op) a`.
static inline IrOp ir_swapped_comparison(IrOp op)
{
    return op == IR_lt ? IR_gt : op == IR_le ? IR_ge : op == IR_gt ? IR_lt : op == IR_ge ? IR_le : op;
}

// Returns the negated comparison: `not (a op b)` equals `a ir_negated_comparison(op) b`.  With a NaN operand this is true only of eq and
// ne, because lt, le, gt and ge are all false.
static inline IrOp ir_negated_comparison(IrOp op)
{
    switch ((int)op) {
    case IR_eq: return IR_ne;
    case IR_ne: return IR_eq;
    case IR_lt: return IR_ge;
    case IR_le: return IR_gt;
    case IR_gt: return IR_le;
    default: return IR_lt;
    }
}

// Returns the result of `a op b`.
static inline bool ir_compare(IrOp op, SmF64 a, SmF64 b)
{
    switch ((int)op) {
    case IR_eq: return sm_eq(a, b);
    case IR_ne: return !sm_eq(a, b);
    case IR_lt: return sm_lt(a, b);
    case IR_le: return sm_le(a, b);
    case IR_gt: return sm_lt(b, a);
    default: return sm_le(b, a);
    }
}

#endif
