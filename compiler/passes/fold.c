// SPDX-License-Identifier: Apache-2.0
// fold: constant folding.  An operation on constants becomes its result.  `and` and `or` become a constant if one operand decides them.
// It computes with stdlib's functions and never with the host's operators, so it cannot disagree with the engines.
// Needs nothing; breaks uses, because the operands lose a user.
#include "compiler/passes/pass.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

static bool is_const(const IrFn *f, IrRef ref)
{
    return f->ins.at[ref].op == IR_const;
}

// The number of a constant of any type: a narrowed operation has the same result as on F64.  Only an F64 can be NaN, and it stays NaN.
static SmF64 f64_of(const IrFn *f, IrRef ref)
{
    const IrIns *i = &f->ins.at[ref];

    return i->type == SM_F64 ? sm_from_bits(i->bits) : sm_cell_to_f64(i->type, i->bits);
}

static void become(IrIns *i, uint64_t bits)
{
    i->op = IR_const;
    i->a = i->b = IR_NONE;
    i->bits = bits;
}

// The result in the operation's type.  (Users of an F32 operation read only its F32 conversion, which is 0 for a NaN.)
static void become_f64(IrIns *i, SmF64 x)
{
    if (i->type == SM_F64)
        become(i, sm_is_nan(x) ? IR_NAN : sm_bits(x));
    else
        become(i, sm_cell_from_f64(i->type, x));
}

static void fold_cvt(const IrFn *f, IrIns *i)
{
    const IrIns *from = &f->ins.at[i->a];

    become(i, sm_cell_from_f64(i->type, sm_cell_to_f64(from->type, from->bits)));
}

// Folds `and` or `or` if the constant `operand` decides it.  Returns false if it does not.
static bool fold_decided(const IrFn *f, IrIns *i, IrRef operand)
{
    bool decides = i->op == IR_or;

    if ((i->op != IR_and && i->op != IR_or) || !is_const(f, operand) || (f->ins.at[operand].bits != 0) != decides)
        return false;
    become(i, decides);
    return true;
}

// Requires that all operands of i are constants.
static void fold_ins(const IrFn *f, IrIns *i)
{
    SmF64 x = i->a != IR_NONE ? f64_of(f, i->a) : sm_from_i32(0);
    SmF64 y = i->b != IR_NONE ? f64_of(f, i->b) : sm_from_i32(0);

    switch (i->op) {
    case IR_const:
    case IR_load:
    case IR_store:
    case IR_stat:
    case IR_sample:
    case IR_OP_COUNT: break;
    case IR_cvt: fold_cvt(f, i); break;
    case IR_add: become_f64(i, sm_add(x, y)); break;
    case IR_sub: become_f64(i, sm_sub(x, y)); break;
    case IR_mul: become_f64(i, sm_mul(x, y)); break;
    case IR_div: become_f64(i, sm_div(x, y)); break;
    case IR_neg: become_f64(i, sm_neg(x)); break;
    case IR_abs: become_f64(i, sm_abs(x)); break;
    case IR_floor: become_f64(i, sm_floor(x)); break;
    case IR_ceil: become_f64(i, sm_ceil(x)); break;
    case IR_trunc: become_f64(i, sm_trunc(x)); break;
    case IR_round: become_f64(i, sm_round(x)); break;
    case IR_sqrt: become_f64(i, sm_sqrt(x)); break;
    case IR_sign: become_f64(i, sm_sign(x)); break;
    case IR_min: become_f64(i, sm_min(x, y)); break;
    case IR_max: become_f64(i, sm_max(x, y)); break;
    case IR_eq: become(i, sm_eq(x, y)); break;
    case IR_ne: become(i, !sm_eq(x, y)); break;
    case IR_lt: become(i, sm_lt(x, y)); break;
    case IR_le: become(i, sm_le(x, y)); break;
    case IR_gt: become(i, sm_lt(y, x)); break;
    case IR_ge: become(i, sm_le(y, x)); break;
    case IR_and: become(i, f->ins.at[i->a].bits && f->ins.at[i->b].bits); break;
    case IR_or: become(i, f->ins.at[i->a].bits || f->ins.at[i->b].bits); break;
    case IR_not: become(i, !f->ins.at[i->a].bits); break;
    }
}

static bool operands_are_const(const IrFn *f, const IrIns *i)
{
    uint8_t n = ir_op_info[i->op].operands;

    return n > 0 && is_const(f, i->a) && (n < 2 || is_const(f, i->b));
}

static void fold_one(IrFn *f, IrIns *i)
{
    if (ir_op_info[i->op].operands == 2 && (fold_decided(f, i, i->a) || fold_decided(f, i, i->b)))
        return;
    if (operands_are_const(f, i))
        fold_ins(f, i);
}

void pass_fold(Arena *arena, IrFn *f, Facts *facts)
{
    (void)arena;
    (void)facts;
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t i = 0; i < f->blk.at[b].ins.n; i++)
            fold_one(f, &f->ins.at[f->blk.at[b].ins.at[i]]);
}
