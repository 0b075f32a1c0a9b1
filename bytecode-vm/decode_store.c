// SPDX-License-Identifier: Apache-2.0
// Stores in the decoded form: X to a local or an output, combined with X's deferred operation where one instruction does both.
#include "bytecode-vm/decode.h"
#include "bytecode-vm/step.h"

// Whether no code reads X after this instruction.  Jumps need not be followed: code at their targets loads X first.
static bool is_x_dead(const DecodeState *d)
{
    SmvmAt at = d->at;

    for (;;) {
        uint32_t shape = smvm_shape(smvm_u8(d->m->image, at++));
        if ((shape & SMVM_SHAPE_X) != 0)
            return false;
        if ((shape & (SMVM_SHAPE_GX | SMVM_SHAPE_Z)) != 0)
            return true;
        while (smvm_u8(d->m->image, at) < SMVM_OP_FIRST)         // skips the operands of a load of Y
            at++;
    }
}

// Emits a store instruction up to its destination operand.  For a local: instruction `family` + `which`.  For one of the first 64 outputs:
// instruction `noting` + `which`, whose first operand is the output's bit.  For any other output: NOTE, then `family` + `which`.  The operand of
// NOTE has a mask in its low eight bits, and above them the index of the byte of parts.stored to which the mask applies.
static void emit_store_op(DecodeState *d, FastOp family, FastOp noting, unsigned which, const StoreTarget *to)
{
    if (to->output && to->index >= 64) {
        smvm_emit_op(d, FAST_NOTE_OP);
        smvm_emit_integer(d, (uint64_t)((to->index - 64) >> 3) << 8 | 1u << (to->index & 7u));
    }
    if (to->output && to->index < 64) {
        smvm_emit_op(d, (unsigned)noting + which);
        smvm_emit_integer(d, (uint64_t)1 << to->index);
    } else {
        smvm_emit_op(d, (unsigned)family + which);
    }
    smvm_emit_operand(d, &to->to);
}

static void emit_store_constant(DecodeState *d, const StoreTarget *to, SmF64 c)  // the operand is c, already converted to the type of `to`
{
    unsigned kind = to->to.kind;
    uint64_t cell = kind == FAST_RAW ? sm_bits(smvm_raw(c)) : sm_cell_from_f64((SmType)kind, c);

    emit_store_op(d, FAST_SET_1_OP, FAST_SETN_1_OP, smvm_type_shift(kind), to);
    smvm_emit_integer(d, cell);
}

// Emits one instruction for `to = x + c`, if register X is that deferred sum, `to` and x have the same integer type, c is a whole number of at most
// 31 bits, and X is dead afterwards.  Otherwise returns false.
static bool try_emit_increment(DecodeState *d, const StoreTarget *to)
{
    DecodedValue x = d->deferred.a, y = d->deferred.b;
    int64_t c;

    if (d->x.kind != DEFERRED || (d->deferred.op != SMVM_add && d->deferred.op != SMVM_sub) || !is_x_dead(d))
        return false;
    if (d->deferred.op == SMVM_add && is_constant(&x))
        swap_values(&x, &y);
    if (!is_integer(&x) || to->to.kind != x.kind || !is_constant(&y) || !smvm_match_whole(y.c, INT32_MAX, &c))
        return false;
    emit_store_op(d, FAST_INC_I8_OP, FAST_INCN_I8_OP, x.kind, to);
    smvm_emit_operand(d, &x);
    smvm_emit_integer(d, (uint64_t)(d->deferred.op == SMVM_sub ? -c : c));
    return true;
}

// Emits one instruction for `to = F op y`, if X is that deferred operation, `to` is an F32 or F64, and y is of that type or a constant.
// Otherwise returns false.
static bool try_emit_operation_to(DecodeState *d, const StoreTarget *to)
{
    static const uint16_t family[2][4][2] = {
        {{FAST_ADDST_F32_OP, FAST_ADDSTN_F32_OP}, {FAST_SUBST_F32_OP, FAST_SUBSTN_F32_OP}, {FAST_MULST_F32_OP, FAST_MULSTN_F32_OP},
         {FAST_DIVST_F32_OP, FAST_DIVSTN_F32_OP}},
        {{FAST_ADDCST_F32_OP, FAST_ADDCSTN_F32_OP}, {FAST_ADDCST_F32_OP, FAST_ADDCSTN_F32_OP}, {FAST_MULCST_F32_OP, FAST_MULCSTN_F32_OP},
         {FAST_DIVCST_F32_OP, FAST_DIVCSTN_F32_OP}},
    };
    DecodedValue y = d->deferred.b;
    const uint8_t op = d->deferred.op;
    const uint16_t *f;

    if (d->x.kind != DEFERRED || op < SMVM_add || op > SMVM_div || !is_in_f(&d->deferred.a) || (to->to.kind != SM_F32 && to->to.kind != SM_F64))
        return false;
    if (y.kind != to->to.kind && !is_constant(&y))
        return false;
    if (is_constant(&y) && op == SMVM_sub)
        y.c = sm_neg(y.c);
    f = family[is_constant(&y)][op - SMVM_add];
    emit_store_op(d, (FastOp)f[0], (FastOp)f[1], to->to.kind - (unsigned)SM_F32, to);
    smvm_emit_operand(d, &y);
    d->x.kind = FAST_IN_F;
    return true;
}

// Emits a store of X.  After a move from memory to memory, X still refers to the source, which the move has not changed: a destination of the
// same type that overlaps the source is the source itself.
static void emit_store(DecodeState *d, const StoreTarget *to)
{
    if (try_emit_increment(d, to) || try_emit_operation_to(d, to) || smvm_try_emit_statistic_to(d, to))
        return;
    if (is_constant(smvm_compute_x(d))) {
        emit_store_constant(d, to, d->x.c);
    } else if (d->x.kind == to->to.kind) {
        emit_store_op(d, FAST_MOV_I8_OP, FAST_MOVN_I8_OP, d->x.kind, to);
        smvm_emit_operand(d, &d->x);
    } else {
        smvm_move_x_to_f(d);
        emit_store_op(d, FAST_ST_I8_OP, FAST_STN_I8_OP, to->to.kind, to);
    }
}

void smvm_decode_store(DecodeState *d, uint8_t op)
{
    StoreTarget to;
    SmvmLocation p;

    to.output = op == SMVM_out;
    to.index = d->n[0];
    if (to.output) {
        p = smvm_output(d->m, d->n[0]);
        to.to = smvm_memory_operand(p.type, AN_ELEMENT, p.offset);
    } else {
        to.to = smvm_memory_operand(op & 15u, A_LOCAL, d->n[0] * size_of_kind(op & 15u));
    }
    emit_store(d, &to);
}
