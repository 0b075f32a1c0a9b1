// SPDX-License-Identifier: Apache-2.0
// Selects the VM's instructions for the IR of a block.  Each value is computed into register X.  Of two operands, one that only needs a load
// goes to register Y.  If both must be computed, the deeper one is computed first and saved in a slot.  Most conversions are performed by a
// load or store and need no instruction: `counter = counter + 1` takes three (load, add, store).
#include "compiler/emit/bytecode/bc_select.h"
#include "stdlib/convert.h"

enum { MUCH_DEEPER = 3 };     // a left operand whose chain of operations is longer than the right one's by more than this is computed first

// ---- where a value can be loaded from ----

// Returns the operand that r can be loaded from; BC_NONE: r must be computed, or only X holds it.
static BcRef find_source_operand(BcSelect *s, IrRef r)
{
    BcValue *v = &s->value[r];

    if (v->slot == BC_LATER)
        v->slot = bc_operand_of(s, bc_ins(s, r));
    return v->slot;
}

// Whether X contains r already.
static bool is_in_x(BcSelect *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);

    if (i->op == IR_stat && !s->value[r].is_computed)
        return bc_register_has(&s->x, bc_stat_operand(s, i->var, i->stat));
    return s->x.value == r || bc_register_has(&s->x, find_source_operand(s, r));
}

// Subtracts one use of r.  After the last use, frees the slot of r.
static void drop_use(BcSelect *s, IrRef r)
{
    BcValue *v = &s->value[r];

    if (v->is_computed && --v->uses_left == 0 && v->slot != BC_NONE)
        bc_slot_free(s, v->slot);
}

static void compute_into_x(BcSelect *s, IrRef r);

// Loads or computes r into X and counts one use.
void bc_bring_to_x(BcSelect *s, IrRef r)
{
    r = bc_skip_exact_cvts(s, r);
    if (!is_in_x(s, r)) {
        if (find_source_operand(s, r) == BC_NONE)
            compute_into_x(s, r);
        else
            bc_load_x(s, find_source_operand(s, r));
        bc_record_x(s, r);
    }
    drop_use(s, r);
}

// Computes waiting value r now, before the instruction that uses it.
static void compute_waiting(BcSelect *s, IrRef r)
{
    if (bc_ins(s, r)->op == IR_load)
        bc_load_x(s, bc_var_operand(s, bc_ins(s, r)->var));
    else
        compute_into_x(s, r);
    bc_record_x(s, r);
    s->value[r].slot = BC_NONE;
    s->value[r].is_computed = true;
    s->value[r].waits = false;
}

// ---- two operands ----

static bool must_be_computed(BcSelect *s, IrRef r) { return !is_in_x(s, r) && find_source_operand(s, r) == BC_NONE; }

// Whether loading b into X and a into Y needs fewer instructions than a into X and b into Y.
static bool is_better_swapped(BcSelect *s, IrRef a, IrRef b)
{
    const bool a_is_loadable = find_source_operand(s, a) != BC_NONE, b_is_loadable = find_source_operand(s, b) != BC_NONE;

    if (b_is_loadable)
        return a_is_loadable && !is_in_x(s, a) && (is_in_x(s, b) || (bc_ins(s, a)->op == IR_const && bc_ins(s, b)->op != IR_const));
    if (a_is_loadable || (is_in_x(s, a) && must_be_computed(s, b)))
        return true;
    return must_be_computed(s, a) && must_be_computed(s, b) && bc_chain_depth(s, a) > bc_chain_depth(s, b);
}

// Ensures that, once a is in X, b can be loaded into Y.
static void ensure_loadable(BcSelect *s, IrRef b, IrRef a)
{
    if (!s->value[b].is_computed && find_source_operand(s, b) == BC_NONE)
        compute_waiting(s, b);
    if (find_source_operand(s, b) == BC_NONE && is_in_x(s, a))                // if a is not in X, bringing a into X saves b
        bc_save_x(s);
}

// Loads or computes a into X and b into Y.  If `may_swap` and fewer instructions result, exchanges them and returns true.
bool bc_load_operands(BcSelect *s, IrRef a, IrRef b, bool may_swap, bool keep)
{
    bool swapped;

    a = bc_skip_exact_cvts(s, a);
    b = bc_skip_exact_cvts(s, b);
    swapped = may_swap && is_better_swapped(s, a, b);
    if (swapped) {
        const IrRef c = a;
        a = b;
        b = c;
    }
    if (must_be_computed(s, a) && must_be_computed(s, b) && bc_chain_depth(s, a) > bc_chain_depth(s, b) + MUCH_DEEPER)
        compute_waiting(s, a);
    ensure_loadable(s, b, a);
    bc_bring_to_x(s, a);
    if (keep)
        bc_save_x(s);
    bc_load_y(s, find_source_operand(s, b));
    drop_use(s, b);
    return swapped;
}

// Sets *n if r is a constant that an instruction can encode as a whole number.  Returns false if not.
static bool match_whole_const(const BcSelect *s, IrRef r, int32_t *n)
{
    return bc_ins(s, r)->op == IR_const && bc_try_whole(bc_const_value(bc_ins(s, r)), n);
}

// X = a + n, by an instruction that contains n.
static void emit_add_number(BcSelect *s, IrRef a, int32_t n)
{
    bc_bring_to_x(s, a);
    bc_save_x(s);
    if (n < 0)
        bc_emit_changing_x(s, SMVM_subi, (uint32_t)-n);
    else
        bc_emit_changing_x(s, SMVM_addi, (uint32_t)n);
}

// X = a + b. A whole constant, on either side, becomes part of the instruction.
static void compute_add(BcSelect *s, IrRef a, IrRef b)
{
    int32_t n;

    if (match_whole_const(s, b, &n) && n > -(int32_t)SMVM_VARINT_END) {
        emit_add_number(s, a, n);
    } else if (match_whole_const(s, a, &n) && n > -(int32_t)SMVM_VARINT_END) {
        emit_add_number(s, b, n);
    } else {
        bc_load_operands(s, a, b, true, true);
        bc_emit_changing_x(s, SMVM_add, 0);
    }
}

// Computes a - b where only a can be loaded: as -b + a, which is the same number.
static void compute_swapped_sub(BcSelect *s, IrRef a, IrRef b)
{
    bc_bring_to_x(s, b);
    bc_save_x(s);
    bc_emit_changing_x(s, SMVM_neg, 0);
    bc_load_y(s, find_source_operand(s, a));
    drop_use(s, a);
    bc_emit_changing_x(s, SMVM_add, 0);
}

// X = a - b. A whole constant b becomes part of the instruction.
static void compute_sub(BcSelect *s, IrRef a, IrRef b)
{
    int32_t n;

    if (match_whole_const(s, b, &n) && n != 0 && n > -(int32_t)SMVM_VARINT_END) {
        emit_add_number(s, a, -n);
        return;
    }
    if (must_be_computed(s, a) && must_be_computed(s, b) && bc_chain_depth(s, a) > bc_chain_depth(s, b) + MUCH_DEEPER)
        compute_waiting(s, a);
    if (is_in_x(s, a) && must_be_computed(s, b))
        bc_save_x(s);
    if (find_source_operand(s, a) != BC_NONE && find_source_operand(s, b) == BC_NONE) {
        compute_swapped_sub(s, a, b);
    } else {
        bc_load_operands(s, a, b, false, true);
        bc_emit_changing_x(s, SMVM_sub, 0);
    }
}

// ---- operations ----

// Returns the opcode of an operation whose operands and result have one type (SAME in compiler/ir/ops.def).
static uint8_t opcode_of(IrOp op)
{
    static const uint8_t of[IR_OP_COUNT] = {
#define OPCODE_SAME(name) [IR_##name] = SMVM_##name,
#define OPCODE_CONST(name)
#define OPCODE_CONVERT(name)
#define OPCODE_COMPARE(name)
#define OPCODE_LOGIC(name)
#define OPCODE_LOAD(name)
#define OPCODE_STORE(name)
#define OPCODE_SAMPLE(name)
#define OPCODE_STAT(name)
#define IR_OP(name, operands, types, narrow, effect, commutes, nan, meaning) OPCODE_##types(name)
#include "compiler/ir/ops.def"
#undef IR_OP
    };

    return of[op];
}

// Returns the outcomes for which comparison `op` is true, as a set of bits SMVM_LESS, SMVM_EQUAL, …
uint32_t bc_relation_of(IrOp op)
{
    switch (op) {
    case IR_eq: return SMVM_EQUAL;
    case IR_ne: return SMVM_LESS | SMVM_GREATER | SMVM_UNORDERED;
    case IR_lt: return SMVM_LESS;
    case IR_le: return SMVM_LESS | SMVM_EQUAL;
    case IR_gt: return SMVM_GREATER;
    case IR_ge: return SMVM_GREATER | SMVM_EQUAL;
    default: return 0;
    }
}

// Returns the set of outcomes with X and Y exchanged: LESS becomes GREATER.
uint32_t bc_swapped_relation(uint32_t relation)
{
    return (relation & (SMVM_EQUAL | SMVM_UNORDERED)) | (relation & SMVM_LESS ? (uint32_t)SMVM_GREATER : 0)
           | (relation & SMVM_GREATER ? (uint32_t)SMVM_LESS : 0);
}

uint32_t bc_negated_relation(uint32_t relation) { return (SMVM_LESS | SMVM_EQUAL | SMVM_GREATER | SMVM_UNORDERED) & ~relation; }

// Whether the negation of boolean r can be computed at the same cost as r.  If `now`, also makes compute_into_x compute the negation.
static bool try_negate(BcSelect *s, IrRef r, bool now)
{
    const IrIns *i = bc_ins(s, r = bc_skip_truth_cvts(s, r));
    const bool both = i->op == IR_and || i->op == IR_or;

    if (!s->value[r].waits || (!both && ir_op_info[i->op].types != IR_T_COMPARE) ||
        (both && (!try_negate(s, i->a, now) || !try_negate(s, i->b, now))))
        return false;
    s->value[r].inverted = s->value[r].inverted != now;
    return true;
}

static void compute_not(BcSelect *s, IrRef a)
{
    if (try_negate(s, a, false)) {
        try_negate(s, a, true);
        compute_into_x(s, a);
        return;
    }
    bc_bring_to_x(s, a);
    bc_save_x(s);
    bc_load_y(s, bc_const_operand(s, sm_from_i32(0)));
    bc_emit_changing_x(s, SMVM_set, SMVM_EQUAL | SMVM_UNORDERED);
}

// If X holds integer r, which may be computed as -0, and becomes a float, emits a conversion that turns -0 into 0.  Returns whether it did.
static bool emit_zero_normalization(BcSelect *s, IrRef r, SmType to)
{
    if (!bc_is_float(to) || !s->value[r].minus_zero)
        return false;
    bc_save_x(s);
    bc_emit_changing_x(s, SMVM_cvt, (uint32_t)bc_ins(s, r)->type);
    return true;
}

// Converts i->a to i->type in X. Conversions inside i->a that cannot change the result are skipped.
static void compute_cvt(BcSelect *s, const IrIns *i)
{
    const IrRef r = i->type == SM_BOOL ? bc_skip_exact_cvts(s, bc_skip_truth_cvts(s, i->a)) : bc_skip_store_cvts(s, i->a, i->type);

    bc_bring_to_x(s, r);
    if (emit_zero_normalization(s, r, i->type) ? bc_is_within(bc_ins(s, r)->type, i->type) : bc_is_exact(s, r, i->type))
        return;
    bc_save_x(s);
    bc_emit_changing_x(s, SMVM_cvt, (uint32_t)i->type);
}

// Emits an operation on X, or on X and Y, that computes X.
static void emit_operation(BcSelect *s, IrOp op)
{
    static const uint8_t number_of[IR_OP_COUNT] = {
#define SM_ELEMENTARY(name, arguments, number) [IR_##name] = (number),
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    };

    bc_emit_changing_x(s, opcode_of(op), number_of[op]);
    if (ir_is_elementary(op))
        bc_forget_y(s);
}

// Computes an operation into X.
static void compute_into_x(BcSelect *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);
    const bool inverted = s->value[r].inverted;

    if (i->op == IR_cvt) {
        compute_cvt(s, i);
    } else if (i->op == IR_stat) {
        bc_load_x(s, bc_stat_operand(s, i->var, i->stat));
    } else if (i->op == IR_not) {
        compute_not(s, bc_skip_truth_cvts(s, i->a));
    } else if (i->op == IR_add) {
        compute_add(s, i->a, i->b);
    } else if (i->op == IR_sub) {
        compute_sub(s, bc_skip_exact_cvts(s, i->a), bc_skip_exact_cvts(s, i->b));
    } else if (ir_op_info[i->op].types == IR_T_COMPARE) {
        const bool swapped = bc_load_operands(s, i->a, i->b, true, true);
        const uint32_t relation = swapped ? bc_swapped_relation(bc_relation_of(i->op)) : bc_relation_of(i->op);
        bc_emit_changing_x(s, SMVM_set, inverted ? bc_negated_relation(relation) : relation);
    } else if (ir_op_info[i->op].types == IR_T_LOGIC) {
        bc_load_operands(s, bc_skip_truth_cvts(s, i->a), bc_skip_truth_cvts(s, i->b), true, true);
        bc_emit_changing_x(s, (i->op == IR_and) != inverted ? SMVM_and : SMVM_or, 0);
    } else if (ir_op_info[i->op].operands == 2) {
        bc_load_operands(s, i->a, i->b, ir_op_info[i->op].commutes, true);
        emit_operation(s, i->op);
    } else {
        bc_bring_to_x(s, i->a);
        bc_save_x(s);
        emit_operation(s, i->op);
    }
}

// ---- instructions ----

// Whether all later users of r, which is in X, can read it from the variable that the store `at` writes.
static bool users_can_read_variable(const BcSelect *s, IrRef r, const BcValue *at)
{
    const BcValue *v = &s->value[r];

    return v->is_computed && v->uses_left > 0 && v->slot == BC_NONE && s->x.value == r && at->next_store >= v->last;
}

static void select_store(BcSelect *s, const IrIns *i, const BcValue *at)
{
    const IrRef r = bc_skip_store_cvts(s, i->a, i->type);
    const BcRef d = bc_var_operand(s, i->var);
    bool same = bc_is_exact(s, r, i->type);

    bc_bring_to_x(s, r);
    emit_zero_normalization(s, r, i->type);
    if (same && users_can_read_variable(s, r, at)) {
        s->value[r].slot = d;
        bc_drop_cvt(s, (uint32_t)i->type);
        same = s->x.value == r;
    }
    bc_store_x(s, d, same && !s->value[r].minus_zero);           // where X is -0, the variable contains 0
}

// Adds the value of i->a as a sample to the rolling window i->var.
static void select_sample(BcSelect *s, const IrIns *i)
{
    const IrRef r = bc_skip_exact_cvts(s, i->a);

    bc_bring_to_x(s, r);
    emit_zero_normalization(s, r, s->m->ir->window.at[i->var].type);
    bc_sample_x(s, s->m->window_number[i->var]);
}

void bc_select_ins(BcSelect *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);
    const BcValue *v = &s->value[r];

    s->span = i->span;
    if (i->op == IR_store)
        select_store(s, i, v);
    else if (i->op == IR_sample)
        select_sample(s, i);
    else if (v->uses > 0 && !v->waits && i->op != IR_const && (i->op != IR_load || v->early))
        compute_waiting(s, r);
}
