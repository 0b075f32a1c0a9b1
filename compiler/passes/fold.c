// SPDX-License-Identifier: Apache-2.0
// fold: constant folding.  An operation on constants becomes its result (ir/eval.h).  `and` and `or` become a constant if one operand
// decides them.
// Needs no facts; invalidates use counts, because the operands lose a user.
#include "compiler/ir/eval.h"
#include "compiler/passes/pass.h"

static bool is_const(const IrFn *f, IrRef ref)
{
    return f->ins.at[ref].op == IR_const;
}

// Returns the number of a constant; 0 for IR_NONE, which represents an operand that the operation does not have.
static SmF64 const_number(const IrFn *f, IrRef ref)
{
    return ref == IR_NONE ? sm_from_i32(0) : ir_number(f->ins.at[ref].type, f->ins.at[ref].bits);
}

static void replace_by_const(IrIns *i, uint64_t bits)
{
    i->op = IR_const;
    i->a = i->b = IR_NONE;
    i->bits = bits;
}

static bool is_decided_by(const IrFn *f, const IrIns *i, IrRef operand)
{
    return is_const(f, operand) && ir_decides(i->op, f->ins.at[operand].bits != 0);
}

static void fold_instruction(const IrFn *f, IrIns *i)
{
    const uint8_t n = ir_op_info[i->op].operands;

    if (ir_op_info[i->op].effect || n == 0)
        return;
    if (n == 2 && (is_decided_by(f, i, i->a) || is_decided_by(f, i, i->b)))
        replace_by_const(i, i->op == IR_or);
    else if (is_const(f, i->a) && (n < 2 || is_const(f, i->b)))
        replace_by_const(i, ir_cell(i->type, ir_eval(i->op, i->type, const_number(f, i->a), const_number(f, i->b))));
}

// The pass `fold`: computes operations on numbers that are known.
void pass_fold(Arena *arena, IrFn *f, Facts *facts)
{
    (void)arena;
    (void)facts;
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t i = 0; i < f->blk.at[b].ins.n; i++)
            fold_instruction(f, &f->ins.at[f->blk.at[b].ins.at[i]]);
}
