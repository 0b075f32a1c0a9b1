// SPDX-License-Identifier: Apache-2.0
// Handles X during decoding: an operation that sets X is deferred until the decoder knows how its result is used.
#include <string.h>

#include "bytecode-vm/decode.h"

// ---- emits operations, whose result is in F ----

static void emit_unary(DecodeState *d, uint8_t op, const DecodedValue *x)
{
    static const uint16_t unary_ops[] = {FAST_NEG_OP, FAST_ABS_OP, FAST_FLOOR_OP, FAST_CEIL_OP, FAST_TRUNC_OP, FAST_ROUND_OP, FAST_SQRT_OP,
                                         FAST_SIGN_OP};

    smvm_emit_load(d, x);
    smvm_emit_op(d, unary_ops[op - SMVM_neg]);
}

// The families of instructions for an operation on two operands.  `with`: F op y.  `number`: x in memory op a constant.  `number_first`: a
// constant op y in memory.  `pair`: two operands of one type in memory.
typedef struct OperationVariants { uint16_t with, number, number_first, pair; } OperationVariants;

static const OperationVariants variants[] = {               // indexed by op - SMVM_add, up to SMVM_or; 0: there is no such instruction
    {FAST_ADD_I8_OP, FAST_ADDC_I8_OP, FAST_ADDC_I8_OP, FAST_ADD2_I8_OP},
    {FAST_SUB_I8_OP, FAST_ADDC_I8_OP, FAST_RSUBC_I8_OP, FAST_SUB2_I8_OP},
    {FAST_MUL_I8_OP, FAST_MULC_I8_OP, FAST_MULC_I8_OP, FAST_MUL2_I8_OP},
    {FAST_DIV_I8_OP, FAST_DIVC_I8_OP, FAST_RDIVC_I8_OP, FAST_DIV2_I8_OP},
    {FAST_MIN_I8_OP, 0, 0, 0},
    {FAST_MAX_I8_OP, 0, 0, 0},
    {FAST_AND_I8_OP, 0, 0, 0},
    {FAST_OR_I8_OP, 0, 0, 0},
};

static void emit_binary(DecodeState *d, uint8_t op, DecodedValue x, DecodedValue y)
{
    const OperationVariants *f = &variants[op - SMVM_add];

    if (op == SMVM_sub && is_constant(&y)) {          // x - c equals x + -c, also for zeros
        y.c = sm_neg(y.c);
        f = &variants[0];
    }
    if (is_in_f(&x)) {
        smvm_emit_operation_on_f(d, (FastOp)f->with, &y);
    } else if (is_in_f(&y)) {                         // a subtraction: in others, smvm_defer_operation has made the operand in F the first
        smvm_emit_operation_on_f(d, FAST_RSUB_I8_OP, &x);
    } else if (is_memory(&x) && is_constant(&y) && f->number != 0) {
        smvm_emit_two_operands(d, (FastOp)f->number, &x, &y);
    } else if (is_constant(&x) && is_memory(&y) && f->number_first != 0) {
        smvm_emit_two_operands(d, (FastOp)f->number_first, &y, &x);
    } else if (is_memory(&x) && x.kind == y.kind && f->pair != 0) {
        smvm_emit_two_operands(d, (FastOp)f->pair, &x, &y);
    } else {
        smvm_emit_load(d, &x);
        smvm_emit_operation_on_f(d, (FastOp)f->with, &y);
    }
}

// ---- relations of x to y: sums of SMVM_LESS, SMVM_EQUAL, SMVM_GREATER, SMVM_UNORDERED ----

// Returns m, a set of relations of x to y, without the impossible ones: 0 if the condition is never true, 15 if it is always true.
unsigned smvm_possible_relations(unsigned m, const DecodedValue *x, const DecodedValue *y)
{
    unsigned can = is_never_nan(x) && is_never_nan(y) ? 7u : 15u;

    return (m & can) == 0 ? 0 : (m & can) == can ? 15u : m & can;
}

// Adds UNORDERED to m if m is `less or greater` and neither operand can be NaN.
unsigned smvm_add_unordered(unsigned m, const DecodedValue *x, const DecodedValue *y)
{
    return m == IS_TRUE && is_never_nan(x) && is_never_nan(y) ? m | SMVM_UNORDERED : m;
}

// Emits F = 1 if x is in one of the relations m to y, else 0.
static void emit_set(DecodeState *d, unsigned m, DecodedValue x, DecodedValue y)
{
    static const uint16_t set_ops[16] = {0, FAST_LT_I8_OP, FAST_EQ_I8_OP, FAST_LE_I8_OP, FAST_GT_I8_OP, 0, FAST_GE_I8_OP, 0, 0, 0, 0, 0, 0,
                                         FAST_NE_I8_OP, 0, 0};
    DecodedValue c;

    m = smvm_possible_relations(m, &x, &y);
    if (m == 0 || m == 15) {
        c = smvm_constant_operand(sm_from_bool(m != 0));
        smvm_emit_load(d, &c);
        return;
    }
    m = smvm_add_unordered(m, &x, &y);
    smvm_emit_load(d, &x);
    if (is_zero(&y) && set_ops[m] == 0 && (m == IS_TRUE || m == IS_FALSE)) {
        smvm_emit_op(d, m == IS_TRUE ? FAST_TRUTH_OP : FAST_NOT_OP);
        return;
    }
    smvm_emit_operation_on_f(d, (FastOp)(set_ops[m] != 0 ? set_ops[m] : FAST_REL_I8_OP), &y);
    if (set_ops[m] == 0)
        smvm_emit_integer(d, m);
}

// ---- deferred X ----

// Emits the deferred operation of X.  Its result is then in F.
static void emit_deferred(DecodeState *d)
{
    const DeferredOp *l = &d->deferred;

    if (l->op == SMVM_stat) {
        smvm_emit_statistic(d);
    } else if (l->op == SMVM_set) {
        emit_set(d, l->n, l->a, l->b);
    } else if (l->op == SMVM_cvt) {
        smvm_emit_load(d, &l->a);
        smvm_emit_op(d, (unsigned)FAST_CVT_I8_OP + l->n);
    } else if (l->op == SMVM_fn) {
        smvm_emit_load(d, &l->a);
        if (l->n < SMVM_FN_OF_TWO)
            smvm_emit_op(d, FAST_FN_OP);
        else
            smvm_emit_operation_on_f(d, FAST_FN2_I8_OP, &l->b);
        smvm_emit_integer(d, l->n);
    } else if (l->op < SMVM_neg) {
        emit_binary(d, l->op, l->a, l->b);
    } else {
        emit_unary(d, l->op, &l->a);
    }
    d->x.kind = FAST_IN_F;
}

// Emits the deferred operation of X, if it has one; returns X, no longer DEFERRED.
DecodedValue *smvm_compute_x(DecodeState *d)
{
    if (d->x.kind == DEFERRED)
        emit_deferred(d);
    return &d->x;
}

// Emits code after which register F contains X.
void smvm_move_x_to_f(DecodeState *d)
{
    smvm_emit_load(d, smvm_compute_x(d));
    d->x.kind = FAST_IN_F;
}

// Whether a conversion of X to this type changes nothing: X was read from a variable of the type, or is 0 or 1, which all types can represent.
static bool is_of_type(const DecodeState *d, uint32_t type)
{
    const uint8_t kind = d->x.kind, op = d->deferred.op;

    return kind == type || kind == SM_BOOL || (kind == DEFERRED && (op == SMVM_set || op == SMVM_and || op == SMVM_or));
}

// Defers X = op X, or X = X op y.
void smvm_defer_operation(DecodeState *d, uint8_t op, DecodedValue y)
{
    bool opposite = d->x.kind == DEFERRED && d->deferred.op == SMVM_neg && op == SMVM_add;  // y + -a is y - a
    DecodedValue x;

    if (op == SMVM_cvt && is_of_type(d, d->n[0]))
        return;
    x = opposite ? d->deferred.a : *smvm_compute_x(d);
    memset(&d->deferred, 0, sizeof d->deferred);
    d->deferred.op = opposite ? SMVM_sub : op;
    d->deferred.n = d->n[0];
    d->deferred.w = d->n[1];
    d->deferred.a = opposite ? y : x;
    d->deferred.b = opposite ? x : y;
    d->x.kind = DEFERRED;
}
