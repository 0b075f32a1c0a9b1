// SPDX-License-Identifier: Apache-2.0
// Jumps in the decoded form, together with their comparisons.  A condition is a sum of relations of x to y: SMVM_LESS and so on.
#include "bytecode-vm/decode.h"

// Returns the relations of y to x for which x is in one of the relations m to y: exchanges SMVM_LESS and SMVM_GREATER.
static unsigned mirror_relation(unsigned m) { return (m & (SMVM_EQUAL | SMVM_UNORDERED)) | (m & SMVM_LESS) << 2 | (m & SMVM_GREATER) >> 2; }

// Returns which relation of x to y is true: SMVM_LESS, SMVM_EQUAL, SMVM_GREATER or SMVM_UNORDERED.
static unsigned relation_between(SmF64 x, SmF64 y)
{
    if (sm_lt(x, y))
        return SMVM_LESS;
    return sm_lt(y, x) ? SMVM_GREATER : sm_eq(x, y) ? SMVM_EQUAL : SMVM_UNORDERED;
}

// The families of instructions that test a condition, indexed by its relations; 0: no family tests it.  `with` compares F with y, `pair` two
// values of one type in memory, `number` a value in memory with a constant, `whole` an integer in memory with an integer constant.  The
// operands of `pair` and `whole` are never NaN.
typedef struct JumpVariants { uint16_t with, pair, number, whole; } JumpVariants;

static const JumpVariants conditions[16] = {
    {0, 0, 0, 0},
    {FAST_JLT_I8_OP, FAST_JLT2_I8_OP, FAST_JLTC_I8_OP, FAST_JLTI_I8_OP},
    {FAST_JEQ_I8_OP, FAST_JEQ2_I8_OP, FAST_JEQC_I8_OP, FAST_JEQI_I8_OP},
    {FAST_JLE_I8_OP, FAST_JLE2_I8_OP, FAST_JLEC_I8_OP, FAST_JLEI_I8_OP},
    {FAST_JGT_I8_OP, 0, FAST_JGTC_I8_OP, FAST_JGTI_I8_OP},
    {0, 0, 0, 0},
    {FAST_JGE_I8_OP, 0, FAST_JGEC_I8_OP, FAST_JGEI_I8_OP},
    {0, 0, 0, 0},
    {0, 0, 0, 0},
    {FAST_JNGE_I8_OP, 0, FAST_JNGEC_I8_OP, 0},
    {0, 0, 0, 0},
    {FAST_JNGT_I8_OP, 0, FAST_JNGTC_I8_OP, 0},
    {FAST_JNLE_I8_OP, 0, FAST_JNLEC_I8_OP, 0},
    {FAST_JNE_I8_OP, FAST_JNE2_I8_OP, FAST_JNEC_I8_OP, FAST_JNEI_I8_OP},
    {FAST_JNLT_I8_OP, 0, FAST_JNLTC_I8_OP, 0},
    {0, 0, 0, 0},
};

// Emits the fast interpreter's jump operation and its target.
void smvm_emit_jump(DecodeState *d, unsigned op, uint32_t target)
{
    smvm_emit_op(d, op);
    smvm_emit_target(d, target);
}

// Emits a conditional jump, taken if x is true (`when`) or if x is not true (not `when`).
static void emit_jump_on_truth(DecodeState *d, bool when, const DecodedValue *x, uint32_t target)
{
    if (is_memory(x)) {
        smvm_emit_jump(d, (when ? (unsigned)FAST_JT_I8_OP : (unsigned)FAST_JF_I8_OP) + x->kind, target);
        smvm_emit_operand(d, x);
        return;
    }
    smvm_emit_load(d, x);
    smvm_emit_jump(d, when ? FAST_JT_A_OP : FAST_JF_A_OP, target);
}

// Emits a conditional jump, taken if F, which may be NaN, is in one of the relations m to y.
static void emit_jump_comparing_f(DecodeState *d, unsigned m, const DecodedValue *y, uint32_t target)
{
    unsigned with = conditions[m].with;

    if (is_zero(y) && (m == IS_TRUE || m == IS_FALSE)) {
        smvm_emit_jump(d, m == IS_TRUE ? FAST_JT_A_OP : FAST_JF_A_OP, target);
        return;
    }
    smvm_emit_jump(d, (with != 0 ? with : (unsigned)FAST_JREL_I8_OP) + y->kind, target);
    smvm_emit_operand(d, y);
    if (with == 0)
        smvm_emit_integer(d, m);
}

// Emits a conditional jump, taken if x, in memory, is in one of the relations m to the constant c.  The instructions compare a stored NaN as
// NaN, but in the language it reads as 0.  Therefore UNORDERED is set in m exactly if 0 satisfies the condition.
static void emit_jump_comparing_constant(DecodeState *d, unsigned m, const DecodedValue *x, const DecodedValue *c, uint32_t target)
{
    int64_t v;

    if (is_integer(x) && smvm_match_whole(c->c, ((int64_t)1 << 53) - 1, &v) && (v >= 0 || x->kind != SM_U64)) {
        smvm_emit_jump(d, (unsigned)conditions[smvm_add_unordered(m, x, c)].whole + x->kind, target);
        smvm_emit_operand(d, x);
        smvm_emit_integer(d, (uint64_t)v);
        return;
    }
    if (is_never_nan(x))
        m = (m & 7u) | ((m & relation_between(sm_from_i32(0), c->c)) != 0 ? SMVM_UNORDERED : 0u);
    if (is_zero(c) && (m == IS_TRUE || m == IS_FALSE))
        emit_jump_on_truth(d, m == IS_TRUE, x, target);
    else if (conditions[m].number != 0) {
        smvm_emit_jump(d, (unsigned)conditions[m].number + x->kind, target);
        smvm_emit_operand(d, x);
        smvm_emit_operand(d, c);
    } else {
        smvm_emit_load(d, x);
        emit_jump_comparing_f(d, m, c, target);
    }
}

// Whether an instruction for this condition exists only with y as the first operand.
static bool must_swap(unsigned m, const DecodedValue *x, const DecodedValue *y)
{
    return is_memory(y) && (is_constant(x) || (x->kind == y->kind && (m == SMVM_GREATER || m == (SMVM_GREATER | SMVM_EQUAL))));
}

// Emits a conditional jump, taken if x is in one of the relations m to y.  Emits an unconditional jump if x is in one of m whatever the
// values, and nothing if it never is.
static void emit_jump_if(DecodeState *d, unsigned m, DecodedValue x, DecodedValue y, uint32_t target)
{
    m = smvm_possible_relations(m, &x, &y);
    if (m == 0)
        return;
    if (m == 15) {
        smvm_emit_jump(d, FAST_JMP_OP, target);
        return;
    }
    if (must_swap(m, &x, &y)) {
        swap_values(&x, &y);
        m = mirror_relation(m);
    }
    if (is_memory(&x) && is_constant(&y)) {
        emit_jump_comparing_constant(d, m, &x, &y, target);
    } else if (is_memory(&x) && is_never_nan(&x) && x.kind == y.kind) {
        smvm_emit_jump(d, (unsigned)conditions[smvm_add_unordered(m, &x, &y)].pair + x.kind, target);
        smvm_emit_operand(d, &x);
        smvm_emit_operand(d, &y);
    } else {
        m = smvm_add_unordered(m, &x, &y);
        smvm_emit_load(d, &x);
        emit_jump_comparing_f(d, m, &y, target);
    }
}

// Decodes jt (`when`) or jf (not `when`).  If X is a deferred comparison, its condition becomes the jump's.
static void decode_jump_truth(DecodeState *d, bool when, uint32_t target)
{
    if (d->x.kind == DEFERRED && d->deferred.op == SMVM_set)
        emit_jump_if(d, when ? d->deferred.n : 15u - d->deferred.n, d->deferred.a, d->deferred.b, target);
    else
        emit_jump_on_truth(d, when, smvm_compute_x(d), target);
}

// Translates a jump instruction.  One with an operand N (jxn) compares X with that number, others that compare do so with Y.
void smvm_decode_jump(DecodeState *d, uint8_t op)
{
    bool has_number = (smvm_shape(op) & SMVM_SHAPE_N) != 0;
    uint32_t target = (uint32_t)(d->at + d->n[has_number] - d->start);
    DecodedValue y = has_number ? smvm_constant_operand(sm_from_u32(d->n[0])) : d->y;

    if (op == SMVM_jmp)
        smvm_emit_jump(d, FAST_JMP_OP, target);
    else if (op == SMVM_jt || op == SMVM_jf)
        decode_jump_truth(d, op == SMVM_jt, target);
    else
        emit_jump_if(d, op & 15u, *smvm_compute_x(d), y, target);
}
