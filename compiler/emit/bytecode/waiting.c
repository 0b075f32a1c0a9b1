// SPDX-License-Identifier: Apache-2.0
// Analyses the instructions of a block before any is selected.  An operation whose result is used once waits: it is computed where its user
// needs it.  A result with several uses is computed at its own position.  Users read a load directly, unless a store to its variable
// precedes the last of them.
#include "compiler/emit/bytecode/bc_select.h"
#include "stdlib/convert.h"

enum { DEEPEST = 100 };       // bound on the chain of waiting operations, and so on the recursion in bc_select.c

// Returns the length of the longest chain of waiting operations in r; 0 if r does not wait. An operation deeper than DEEPEST does not wait
// (count_block_uses), so the chain of an operation that uses it starts again at 0.
uint32_t bc_chain_depth(const BcSelect *s, IrRef r) { return s->value[r].waits && s->value[r].depth <= DEEPEST ? s->value[r].depth : 0; }

// ---- possible values ----

// Whether a store in the type of r would change r.  A store turns NaN into 0, and rounds the result of an F32 operation, which is computed as
// F64.  It does not change the results of loads, conversions and integer operations.
static bool may_change_when_stored(const BcSelect *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);

    if (i->op == IR_const)
        return i->type == SM_F64 && sm_is_nan(sm_from_bits(i->bits));
    return bc_is_float(i->type) && i->op != IR_load && i->op != IR_cvt;
}

// Whether type `b` can represent every number that a variable of type `a` can be read as.  An I64 or U64 is read as an F64.
bool bc_is_within(SmType a, SmType b)
{
    const SmTypeInfo *x = &sm_type_info[a], *y = &sm_type_info[b];

    if (a == b || a == SM_BOOL || b == SM_F64)
        return b != SM_BOOL || a == b;
    if (b == SM_F32)
        return x->bytes < 4;
    if (x->kind == SM_KIND_FLOAT || y->kind == SM_KIND_BOOL)
        return false;
    return x->kind == y->kind ? x->bytes <= y->bytes : x->kind == SM_KIND_UNSIGNED && x->bytes < y->bytes;
}

// Whether type `type` can represent every value of r.
bool bc_is_exact(const BcSelect *s, IrRef r, SmType type)
{
    return !may_change_when_stored(s, r) && bc_is_within(bc_ins(s, r)->type, type) && !(bc_is_float(type) && s->value[r].minus_zero);
}

// ---- conversions that need no instruction ----

// Whether a conversion leaves its operand's number unchanged.
static bool is_exact_cvt(const BcSelect *s, const IrIns *cvt) { return bc_is_exact(s, cvt->a, cvt->type); }

// Returns the value that r is an exact conversion of, through all conversions that have not been emitted yet.
IrRef bc_follow_exact_cvts(const BcSelect *s, IrRef r)
{
    while (bc_is_waiting_cvt(s, r) && is_exact_cvt(s, bc_ins(s, r)))
        r = bc_ins(s, r)->a;
    return r;
}

// Returns r without conversions that do not affect whether it is true.
IrRef bc_skip_truth_cvts(const BcSelect *s, IrRef r)
{
    while (bc_is_waiting_cvt(s, r) && (bc_ins(s, r)->type == SM_BOOL || is_exact_cvt(s, bc_ins(s, r))))
        r = bc_ins(s, r)->a;
    return r;
}

// Whether a store to a variable of `type` makes a preceding conversion to `to` unnecessary.  Both turn NaN into 0, so a conversion of F64 to
// itself is unnecessary.  A conversion that clamps to a range is unnecessary if the store clamps to a narrower range.
static bool store_performs_cvt(SmType to, SmType type)
{
    return to == type || to == SM_F64 || (!bc_is_float(to) && type != SM_BOOL && to != SM_BOOL && bc_is_within(type, to));
}

// Returns r without conversions that a store to that type performs anyway.
IrRef bc_skip_store_cvts(const BcSelect *s, IrRef r, SmType type)
{
    const IrIns *i = bc_ins(s, r);

    for (; s->value[r].waits && i->op == IR_cvt && (store_performs_cvt(i->type, type) || is_exact_cvt(s, i)); i = bc_ins(s, r))
        r = i->a;
    return bc_skip_exact_cvts(s, r);
}

// ---- which operations wait ----

static bool is_pure_operation(IrOp op) { return !ir_op_info[op].effect && op != IR_const && op != IR_load; }

// Counts `times` more uses of value r.  `at`: position in the block of the instruction that uses r.
static void add_use(BcSelect *s, IrRef r, uint32_t at, uint32_t times)
{
    BcValue *v = &s->value[r];

    v->uses += times;
    if (v->last < at)
        v->last = at;
}

// Records a store at position `at`, and in *v the next store to the same variable.
static void note_store(BcSelect *s, const IrIns *i, BcValue *v, uint32_t at)
{
    v->next_store = s->store_in[i->var] == s->count ? s->store_at[i->var] : UINT32_MAX;
    s->store_at[i->var] = at;
    s->store_in[i->var] = s->count;
}

// Counts uses by live instructions, from the end of the block to its start, and decides which operations wait.  `deep_known`: BcValue.depth is
// known from an earlier run, and operations deeper than DEEPEST do not wait.
static void count_block_uses(BcSelect *s, const IrBlk *b, bool deep_known)
{
    s->count++;
    if (b->jump.kind == IR_BR)
        add_use(s, b->jump.cond, (uint32_t)b->ins.n + 1, 1);
    for (uint32_t p = (uint32_t)b->ins.n; p-- > 0;) {
        IrRef r = b->ins.at[p];
        const IrIns *i = bc_ins(s, r);
        BcValue *v = &s->value[r];
        uint32_t at = p + 1;
        bool same;

        if (!ir_op_info[i->op].effect && v->uses == 0)
            continue;
        v->uses_left = v->uses;
        v->slot = i->op == IR_const || i->op == IR_load ? BC_LATER : BC_NONE;
        same = i->op == IR_cvt && is_exact_cvt(s, i);
        v->waits = is_pure_operation(i->op) && (v->uses == 1 || same) && !(deep_known && v->depth > DEEPEST);
        if (v->waits)
            at = v->last;
        if (i->op == IR_load)
            v->early = s->store_in[i->var] == s->count && s->store_at[i->var] < v->last;
        if (i->op == IR_store)
            note_store(s, i, v, p + 1);
        if (ir_op_info[i->op].operands > 0)
            add_use(s, i->a, at, v->waits ? v->uses : 1);
        if (ir_op_info[i->op].operands > 1)
            add_use(s, i->b, at, 1);
    }
}

// ---- the sign of a zero ----

// Whether r is a constant above 0.
static bool is_positive(const BcSelect *s, IrRef r)
{
    return bc_ins(s, r)->op == IR_const && sm_lt(sm_from_i32(0), bc_const_value(bc_ins(s, r)));
}

// Whether an integer can be below zero, judged by its operation; x and y describe its operands.
static bool may_be_negative(const BcSelect *s, const IrIns *i, const BcValue *x, const BcValue *y)
{
    const bool is_signed = sm_type_info[i->type].kind == SM_KIND_SIGNED;

    switch (i->op) {
    case IR_const: return is_signed && sm_lt(bc_const_value(i), sm_from_i32(0));
    case IR_cvt: return is_signed && (bc_is_float(bc_ins(s, i->a)->type) || x->negative);
    case IR_add: case IR_mul: case IR_min: case IR_max: return x->negative || y->negative;
    case IR_sign: return x->negative;
    case IR_abs: return false;
    default: return is_signed;
    }
}

// Whether integer operation i, which the VM computes as an F64, can have the result -0; x and y describe its operands.  A product or negation
// can create a -0; most other operations can return a -0 operand.
static bool may_be_minus_zero(const BcSelect *s, const IrIns *i, const BcValue *x, const BcValue *y)
{
    const bool is_passed_on = x->minus_zero || y->minus_zero;

    switch (i->op) {
    case IR_neg: return true;
    case IR_mul: return is_passed_on || (x->negative && !is_positive(s, i->b)) || (y->negative && !is_positive(s, i->a));
    case IR_cvt: return is_passed_on && is_exact_cvt(s, i);
    case IR_abs: return false;
    default: return is_passed_on;
    }
}

static void find_possible_signs(BcSelect *s, const IrBlk *b)
{
    const BcValue none = {.slot = BC_NONE};

    for (size_t p = 0; p < b->ins.n; p++) {
        const IrIns *i = bc_ins(s, b->ins.at[p]);
        const uint8_t n = ir_op_info[i->op].operands;
        const BcValue *x, *y;
        BcValue *v = &s->value[b->ins.at[p]];
        if (bc_is_float(i->type))
            continue;
        x = n > 0 ? &s->value[i->a] : &none;
        y = n > 1 ? &s->value[i->b] : &none;
        v->negative = may_be_negative(s, i, x, y);
        v->minus_zero = may_be_minus_zero(s, i, x, y);
    }
}

// ---- a block ----

// Sets the depth of r, if it is a pure operation: the length of the chain of operations that would wait with r (be computed where their results
// are used).  Returns whether
// the chain is too long.
static bool set_chain_depth(BcSelect *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);
    uint32_t x, y;

    if (!is_pure_operation(i->op))
        return false;
    x = ir_op_info[i->op].operands > 0 ? bc_chain_depth(s, i->a) : 0;
    y = ir_op_info[i->op].operands > 1 ? bc_chain_depth(s, i->b) : 0;
    s->value[r].depth = 1 + (x > y ? x : y);
    return s->value[r].depth > DEEPEST;
}

// Fills in BcValue for each instruction of a block.
void bc_analyse_block(BcSelect *s, uint32_t block)
{
    const IrBlk *b = &s->f->blk.at[block];
    bool deep = false;

    find_possible_signs(s, b);
    count_block_uses(s, b, false);
    for (size_t p = 0; p < b->ins.n; p++)
        deep |= set_chain_depth(s, b->ins.at[p]);
    if (!deep)
        return;
    for (size_t p = 0; p < b->ins.n; p++) {
        BcValue *v = &s->value[b->ins.at[p]];
        v->uses = v->last = 0;
    }
    count_block_uses(s, b, true);
}
