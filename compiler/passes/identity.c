// SPDX-License-Identifier: Apache-2.0
// identity: bypasses operations whose result equals an operand.  Users of the result name the operand instead.
//   x * 1, x / 1             exact, including the sign of zero
//   x - 0, x + -0            exact, including the sign of zero: -0 - 0 is -0, and 0 + -0 is 0
//   x + 0                    only if x cannot be -0: an integer, a number converted from an integer, or a result of abs
//   --x, min(x, x), max(x, x), min(x, inf), max(x, -inf)
//   floor, ceil, trunc, round  of the result of one of these operations, or of a converted integer, because they do not change whole
//                            numbers, infinities, NaN or the sign of zero
//   two conversions          such as U8 to F64 to U8: if the intermediate type represents every value of the first type exactly
//   cvt to the same type     unless the operand is a float that may be NaN, which cvt would change to 0
//   and, or                  with a constant that does not decide the result, or with the same operand twice
//   not of a not
// algebra.c replaces operations by cheaper ones.
// Needs no facts; invalidates use counts.  dce removes the operations that become unused.
#include "compiler/passes/identity.h"

#include "compiler/ir/eval.h"
#include "compiler/passes/pass.h"

static bool is_float(SmType type) { return type == SM_F64 || type == SM_F32; }

bool identity_is_integer(SmType type) { return !is_float(type) && type != SM_BOOL; }

// Whether ref is a constant, of any type, with this value.
bool identity_is_const(const Identity *d, IrRef ref, SmF64 number)
{
    const IrIns *i = identity_at(d, ref);

    return i->op == IR_const && sm_bits(ir_number(i->type, i->bits)) == sm_bits(number);
}

// ---- arithmetic ----

// Whether ref is an integer or bool that is not the result of arithmetic or a conversion, so that it is certainly not -0.  An integer
// result of a narrowed operation could be -0 if a backend computes the operation on F64 (ir.h).
static bool is_uncomputed_integer(const Identity *d, IrRef ref)
{
    const IrIns *i = identity_at(d, ref);

    return !is_float(i->type) && (ir_op_info[i->op].types != IR_T_SAME && i->op != IR_cvt);
}

// Whether ref is certainly not -0.
static bool is_never_minus_zero(const Identity *d, IrRef ref)
{
    const IrIns *i = identity_at(d, ref);

    return is_uncomputed_integer(d, ref) || i->op == IR_abs || (i->op == IR_cvt && is_uncomputed_integer(d, i->a));
}

static IrRef operand_equal_to_sum(const Identity *d, const IrIns *i)
{
    const SmF64 zero = sm_from_i32(0), neutral = i->op == IR_add ? sm_neg(zero) : zero;

    if (identity_is_const(d, i->b, neutral) || (i->op == IR_add && identity_is_const(d, i->b, zero) && is_never_minus_zero(d, i->a)))
        return i->a;
    if (i->op == IR_add && (identity_is_const(d, i->a, neutral) || (identity_is_const(d, i->a, zero) && is_never_minus_zero(d, i->b))))
        return i->b;
    return IR_NONE;
}

static IrRef operand_equal_to_extreme(const Identity *d, const IrIns *i)
{
    const SmF64 infinity = sm_from_bits(0x7FF0000000000000u), neutral = i->op == IR_min ? infinity : sm_neg(infinity);

    if (i->a == i->b || identity_is_const(d, i->b, neutral))
        return i->a;
    return identity_is_const(d, i->a, neutral) ? i->b : IR_NONE;
}

// ---- conversions ----

static unsigned bit_width(SmType type) { return 8u * sm_type_info[type].bytes; }

static bool is_signed(SmType type) { return type <= SM_I64; }

// Whether `wide` represents every value of `type`, so that a conversion there and back changes nothing.
// An F64 represents every integer of 32 bits, an F32 every integer of 16 bits.
static bool represents_all(SmType wide, SmType type)
{
    if (wide == type || type == SM_BOOL)
        return true;
    if (is_float(wide))
        return is_float(type) ? wide == SM_F64 : bit_width(type) <= (wide == SM_F64 ? 32 : 16);
    if (is_float(type) || wide == SM_BOOL)
        return false;
    return bit_width(wide) > bit_width(type) ? is_signed(wide) || !is_signed(type) : false;
}

static IrRef operand_equal_to_cvt(const Identity *d, const IrIns *i)
{
    const IrIns *from = identity_at(d, i->a);

    if (from->type == i->type)
        return d->never_nan[i->a] ? i->a : IR_NONE;
    if (from->op == IR_cvt && identity_at(d, from->a)->type == i->type && d->never_nan[from->a] && represents_all(from->type, i->type))
        return from->a;
    return IR_NONE;
}

// ---- logic ----

static bool is_bool_const(const Identity *d, IrRef ref, bool value)
{
    return identity_at(d, ref)->op == IR_const && identity_at(d, ref)->bits == value;
}

// Returns a temporary whose value always equals the result of instruction i; IR_NONE if no such temporary is known.
static IrRef find_equal_operand(const Identity *d, const IrIns *i)
{
    const SmF64 one = sm_from_i32(1);
    const IrIns *from;

    switch (i->op) {
    case IR_add:
    case IR_sub: return operand_equal_to_sum(d, i);
    case IR_mul:
        if (identity_is_const(d, i->b, one))
            return i->a;
        return identity_is_const(d, i->a, one) ? i->b : IR_NONE;
    case IR_div: return identity_is_const(d, i->b, one) ? i->a : IR_NONE;
    case IR_neg:
    case IR_not:
        from = identity_at(d, i->a);
        return from->op == i->op ? from->a : IR_NONE;
    case IR_abs: return identity_at(d, i->a)->op == IR_abs ? i->a : IR_NONE;
    case IR_floor: case IR_ceil: case IR_trunc: case IR_round:
        from = identity_at(d, i->a);
        return ir_is_rounding(from->op) || (from->op == IR_cvt && !is_float(identity_at(d, from->a)->type)) ? i->a : IR_NONE;
    case IR_min:
    case IR_max: return operand_equal_to_extreme(d, i);
    case IR_cvt: return operand_equal_to_cvt(d, i);
    case IR_and:
    case IR_or:
        if (i->a == i->b || is_bool_const(d, i->b, i->op == IR_and))
            return i->a;
        return is_bool_const(d, i->a, i->op == IR_and) ? i->b : IR_NONE;
    default: return IR_NONE;
    }
}

static bool is_never_nan(const Identity *d, const IrIns *i)
{
    const IrOpInfo *info = &ir_op_info[i->op];

    if (i->op == IR_const)
        return !sm_is_nan(ir_number(i->type, i->bits));
    return info->nan == IR_NAN_NEVER || (info->nan == IR_NAN_OPERAND && d->never_nan[i->a] && (info->operands < 2 || d->never_nan[i->b]));
}

static void visit_instruction(Identity *d, IrRef ref)
{
    IrIns *i = &d->f->ins.at[ref];
    IrRef same;

    if (ir_op_info[i->op].operands > 0)
        i->a = d->same[i->a];
    if (ir_op_info[i->op].operands > 1)
        i->b = d->same[i->b];
    identity_rewrite_cheaper(d, i);
    same = find_equal_operand(d, i);
    d->same[ref] = same == IR_NONE ? ref : same;
    d->never_nan[ref] = !is_float(i->type) || is_never_nan(d, i);
}

// The pass `identity`: removes operations whose result is an operand unchanged, such as a conversion there and back.
void pass_identity(Arena *arena, IrFn *f, Facts *facts)
{
    Identity d = {f, ARENA_ARRAY(facts->work, IrRef, f->ins.n), ARENA_ARRAY(facts->work, bool, f->ins.n)};

    (void)arena;
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk *blk = &f->blk.at[b];
        for (size_t i = 0; i < blk->ins.n; i++)
            visit_instruction(&d, blk->ins.at[i]);
        if (blk->jump.kind == IR_BR)
            blk->jump.cond = d.same[blk->jump.cond];
    }
}
