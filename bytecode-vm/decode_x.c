// SPDX-License-Identifier: Apache-2.0
// X during decoding: a computation is deferred, as an operation on loaded operands, until the decoder knows how its result is used.
#include <string.h>

#include "bytecode-vm/decode.h"

// ---- operations, whose result is in F ----

static void put_one(Decode *d, uint8_t op, const Value *x)
{
    static const uint16_t plain[] = {FAST_NEG_OP, FAST_ABS_OP, FAST_FLOOR_OP, FAST_CEIL_OP, FAST_TRUNC_OP, FAST_ROUND_OP, FAST_SQRT_OP, FAST_SIGN_OP};

    smvm_put_load(d, x);
    smvm_put_op(d, plain[op - SMVM_neg]);
}

// The forms of an operation on two operands: F op y, x in memory op a number, a number op y in memory, two in memory of one type.
typedef struct Forms { uint16_t with, number, number_first, pair; } Forms;

static const Forms forms[] = {                        // from SMVM_add to SMVM_or; 0: there is no such form
    {FAST_ADD_I8_OP, FAST_ADDC_I8_OP, FAST_ADDC_I8_OP, FAST_ADD2_I8_OP},
    {FAST_SUB_I8_OP, FAST_ADDC_I8_OP, FAST_RSUBC_I8_OP, FAST_SUB2_I8_OP},
    {FAST_MUL_I8_OP, FAST_MULC_I8_OP, FAST_MULC_I8_OP, FAST_MUL2_I8_OP},
    {FAST_DIV_I8_OP, FAST_DIVC_I8_OP, FAST_RDIVC_I8_OP, FAST_DIV2_I8_OP},
    {FAST_MIN_I8_OP, 0, 0, 0},
    {FAST_MAX_I8_OP, 0, 0, 0},
    {FAST_AND_I8_OP, 0, 0, 0},
    {FAST_OR_I8_OP, 0, 0, 0},
};

static void put_two(Decode *d, uint8_t op, Value x, Value y)
{
    const Forms *f = &forms[op - SMVM_add];

    if (op == SMVM_sub && is_number(&y)) {            // x - c equals x + -c, also for zeros
        y.c = sm_neg(y.c);
        f = &forms[0];
    }
    if (is_f(&x)) {
        smvm_put_with(d, (FastOp)f->with, &y);
    } else if (is_f(&y)) {                            // only for sub
        smvm_put_with(d, FAST_RSUB_I8_OP, &x);
    } else if (is_memory(&x) && is_number(&y) && f->number != 0) {
        smvm_put_pair(d, (FastOp)f->number, &x, &y);
    } else if (is_number(&x) && is_memory(&y) && f->number_first != 0) {
        smvm_put_pair(d, (FastOp)f->number_first, &y, &x);
    } else if (is_memory(&x) && x.kind == y.kind && f->pair != 0) {
        smvm_put_pair(d, (FastOp)f->pair, &x, &y);
    } else {
        smvm_put_load(d, &x);
        smvm_put_with(d, (FastOp)f->with, &y);
    }
}

// ---- relations: sums of SMVM_LESS and so on, of x to y ----

unsigned smvm_possible(unsigned m, const Value *x, const Value *y)
{
    unsigned can = is_never_nan(x) && is_never_nan(y) ? 7u : 15u;

    return (m & can) == 0 ? 0 : (m & can) == can ? 15u : m & can;
}

unsigned smvm_with_nan(unsigned m, const Value *x, const Value *y)
{
    return m == IS_TRUE && is_never_nan(x) && is_never_nan(y) ? m | SMVM_UNORDERED : m;
}

static void put_set(Decode *d, unsigned m, Value x, Value y)
{
    static const uint16_t of[16] = {0, FAST_LT_I8_OP, FAST_EQ_I8_OP, FAST_LE_I8_OP, FAST_GT_I8_OP, 0, FAST_GE_I8_OP, 0, 0, 0, 0, 0, 0, FAST_NE_I8_OP, 0, 0};
    Value c;

    m = smvm_possible(m, &x, &y);
    if (m == 0 || m == 15) {
        c = smvm_constant(sm_from_bool(m != 0));
        smvm_put_load(d, &c);
        return;
    }
    m = smvm_with_nan(m, &x, &y);
    smvm_put_load(d, &x);
    if (is_zero(&y) && of[m] == 0 && (m == IS_TRUE || m == IS_FALSE)) {
        smvm_put_op(d, m == IS_TRUE ? FAST_TRUTH_OP : FAST_NOT_OP);
        return;
    }
    smvm_put_with(d, (FastOp)(of[m] != 0 ? of[m] : FAST_REL_I8_OP), &y);
    if (of[m] == 0)
        smvm_put_u(d, m);
}

// ---- deferred X ----

// Puts the deferred operation of X, whose result is then in F.
static void compute(Decode *d)
{
    const Later *l = &d->later;

    if (l->op == SMVM_stat) {
        smvm_put_statistic(d);
    } else if (l->op == SMVM_set) {
        put_set(d, l->n, l->a, l->b);
    } else if (l->op == SMVM_cvt) {
        smvm_put_load(d, &l->a);
        smvm_put_op(d, (unsigned)FAST_CVT_I8_OP + l->n);
    } else if (l->op < SMVM_neg) {
        put_two(d, l->op, l->a, l->b);
    } else {
        put_one(d, l->op, &l->a);
    }
    d->x.kind = FAST_A;
}

Value *smvm_x_of(Decode *d)
{
    if (d->x.kind == LATER)
        compute(d);
    return &d->x;
}

void smvm_load_x(Decode *d)
{
    smvm_put_load(d, smvm_x_of(d));
    d->x.kind = FAST_A;
}

// Whether X already has a value that a local of this type can store: it was read from one, or is 0 or 1, which all types have.
static bool is_of_type(const Decode *d, uint32_t type)
{
    const uint8_t kind = d->x.kind, op = d->later.op;

    return kind == type || kind == SM_BOOL || (kind == LATER && (op == SMVM_set || op == SMVM_and || op == SMVM_or));
}

void smvm_wait_for(Decode *d, uint8_t op, Value y)
{
    bool opposite = d->x.kind == LATER && d->later.op == SMVM_neg && op == SMVM_add;       // y + -a is y - a
    Value x;

    if (op == SMVM_cvt && is_of_type(d, d->n[0]))
        return;
    x = opposite ? d->later.a : *smvm_x_of(d);
    memset(&d->later, 0, sizeof d->later);
    d->later.op = opposite ? SMVM_sub : op;
    d->later.n = d->n[0];
    d->later.w = d->n[1];
    d->later.a = opposite ? y : x;
    d->later.b = opposite ? x : y;
    d->x.kind = LATER;
}
