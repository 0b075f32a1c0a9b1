// SPDX-License-Identifier: Apache-2.0
// identity: an operation that gives a temporary's value unchanged is left out, and its users name that temporary instead.
//   cvt there and back       U8 to F64 to U8: an F64 holds every value of the type exactly (not of I64 and U64)
//   cvt of an F64 to F64     when it cannot be NaN: then there is nothing to change
//   and, or with a number    that does not decide; or with the same operand twice
//   not of a not
// Needs nothing; breaks uses.  What became useless is left to dce.
#include "compiler/passes/pass.h"
#include "stdlib/f64.h"

typedef struct Identity {
    IrFn *f;
    IrRef *same;          // by instruction: the temporary that has the same value, itself if there is none
    bool *never_nan;      // by instruction: an F64 that is certainly a number
} Identity;

static const IrIns *ins_at(const Identity *d, IrRef ref)
{
    return &d->f->ins.at[ref];
}

static bool f64_holds_all(SmType type)
{
    return type != SM_I64 && type != SM_U64 && type != SM_F64;
}

static IrRef same_as_cvt(const Identity *d, const IrIns *i)
{
    const IrIns *from = ins_at(d, i->a);

    if (i->type == SM_F64 && from->type == SM_F64 && d->never_nan[i->a])
        return i->a;
    if (from->op == IR_cvt && from->type == SM_F64 && ins_at(d, from->a)->type == i->type && f64_holds_all(i->type))
        return from->a;
    return IR_NONE;
}

static bool is_bool_const(const Identity *d, IrRef ref, bool value)
{
    return ins_at(d, ref)->op == IR_const && ins_at(d, ref)->bits == value;
}

static IrRef same_as_logic(const Identity *d, const IrIns *i)
{
    bool neutral = i->op == IR_and;

    if (i->a == i->b || is_bool_const(d, i->b, neutral))
        return i->a;
    return is_bool_const(d, i->a, neutral) ? i->b : IR_NONE;
}

// The temporary whose value instruction i gives unchanged; IR_NONE if there is none.
static IrRef same_as(const Identity *d, const IrIns *i)
{
    if (i->op == IR_cvt)
        return same_as_cvt(d, i);
    if (i->op == IR_and || i->op == IR_or)
        return same_as_logic(d, i);
    if (i->op == IR_not && ins_at(d, i->a)->op == IR_not)
        return ins_at(d, i->a)->a;
    return IR_NONE;
}

static bool is_never_nan(const Identity *d, const IrIns *i)
{
    switch (i->op) {
    case IR_const: return !sm_is_nan(sm_from_bits(i->bits));
    case IR_load:
    case IR_cvt: return true;
    case IR_neg:
    case IR_abs:
    case IR_floor:
    case IR_ceil:
    case IR_trunc:
    case IR_round:
    case IR_sign: return d->never_nan[i->a];
    case IR_min:
    case IR_max: return d->never_nan[i->a] && d->never_nan[i->b];
    case IR_add:                      // inf - inf
    case IR_sub:
    case IR_mul:                      // 0 * inf
    case IR_div:
    case IR_sqrt:
    case IR_stat:
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge:
    case IR_and: case IR_or: case IR_not:
    case IR_store: case IR_sample: case IR_OP_COUNT: break;
    }
    return false;
}

static void visit(Identity *d, IrRef ref)
{
    IrIns *i = &d->f->ins.at[ref];
    IrRef same;

    if (ir_op_info[i->op].operands > 0)
        i->a = d->same[i->a];
    if (ir_op_info[i->op].operands > 1)
        i->b = d->same[i->b];
    same = same_as(d, i);
    d->same[ref] = same == IR_NONE ? ref : same;
    d->never_nan[ref] = i->type == SM_F64 && is_never_nan(d, i);
}

void pass_identity(Arena *arena, IrFn *f, Facts *facts)
{
    Identity d = {f, ARENA_ARRAY(arena, IrRef, f->ins.n), ARENA_ARRAY(arena, bool, f->ins.n)};

    (void)facts;
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk *blk = &f->blk.at[b];
        for (size_t i = 0; i < blk->ins.n; i++)
            visit(&d, blk->ins.at[i]);
        if (blk->jump.kind == IR_BR)
            blk->jump.cond = d.same[blk->jump.cond];
    }
}
