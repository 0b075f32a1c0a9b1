// SPDX-License-Identifier: Apache-2.0
// IR to instructions, within a block.  Each value is computed into X.  Of two operands, one that only needs a load goes to Y. If both must
// be computed, the deeper one is computed first and waits in a slot.  Loads, stores and most conversions cost nothing besides the load or
// store itself: `counter = counter + 1` is three instructions.
#include "compiler/emit/bytecode/bc_select.h"
#include "stdlib/convert.h"

enum { MUCH_DEEPER = 3 };     // a left side deeper than the right by more than this is computed first: fewer right sides wait

// ---- the location of a value ----

// The operand that r can be loaded from; BC_NONE: r must be computed, or only X holds it.
static BcRef place_of(Select *s, IrRef r)
{
    Value *v = &s->value[r];

    if (v->slot == BC_UNASKED)
        v->slot = bc_operand_of(s, bc_ins(s, r));
    return v->slot;
}

static bool x_holds(Select *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);

    if (i->op == IR_stat && !s->value[r].placed)
        return bc_holds(&s->x, bc_stat_operand(s, i->var, i->stat));
    return s->x.value == r || bc_holds(&s->x, place_of(s, r));
}

static void used(Select *s, IrRef r)
{
    Value *v = &s->value[r];

    if (v->placed && --v->left == 0 && v->slot != BC_NONE)
        bc_slot_give(s, v->slot);
}

static void compute(Select *s, IrRef r);

void bc_to_x(Select *s, IrRef r)
{
    r = bc_source(s, r);
    if (!x_holds(s, r)) {
        if (place_of(s, r) == BC_NONE)
            compute(s, r);
        else
            bc_load_x(s, place_of(s, r));
        bc_x_is(s, r);
    }
    used(s, r);
}

// Computes a waiting value before its use.
static void place(Select *s, IrRef r)
{
    if (bc_ins(s, r)->op == IR_load)
        bc_load_x(s, bc_var_operand(s, bc_ins(s, r)->var));
    else
        compute(s, r);
    bc_x_is(s, r);
    s->value[r].slot = BC_NONE;
    s->value[r].placed = true;
    s->value[r].waits = false;
}

// ---- two operands ----

static bool is_to_come(Select *s, IrRef r) { return !x_holds(s, r) && place_of(s, r) == BC_NONE; }

static bool better_turned(Select *s, IrRef a, IrRef b)
{
    const bool a_lies = place_of(s, a) != BC_NONE, b_lies = place_of(s, b) != BC_NONE;

    if (b_lies)
        return a_lies && !x_holds(s, a) && (x_holds(s, b) || (bc_ins(s, a)->op == IR_const && bc_ins(s, b)->op != IR_const));
    if (a_lies || (x_holds(s, a) && is_to_come(s, b)))
        return true;
    return is_to_come(s, a) && is_to_come(s, b) && bc_depth(s, a) > bc_depth(s, b);
}

// Ensures that b can be loaded into Y once a is in X.
static void lay_down(Select *s, IrRef b, IrRef a)
{
    if (!s->value[b].placed && place_of(s, b) == BC_NONE)
        place(s, b);
    if (place_of(s, b) == BC_NONE && x_holds(s, a))              // otherwise b is saved when a is computed into X
        bc_keep_x(s);
}

bool bc_operands(Select *s, IrRef a, IrRef b, bool turns, bool keep)
{
    bool turned;

    a = bc_source(s, a);
    b = bc_source(s, b);
    turned = turns && better_turned(s, a, b);
    if (turned) {
        const IrRef c = a;
        a = b;
        b = c;
    }
    if (is_to_come(s, a) && is_to_come(s, b) && bc_depth(s, a) > bc_depth(s, b) + MUCH_DEEPER)
        place(s, a);
    lay_down(s, b, a);
    bc_to_x(s, a);
    if (keep)
        bc_keep_x(s);
    bc_load_y(s, place_of(s, b));
    used(s, b);
    return turned;
}

// Whether r is a number that an instruction can encode; then sets *n to it.
static bool is_whole(const Select *s, IrRef r, int32_t *n)
{
    return bc_ins(s, r)->op == IR_const && bc_whole(bc_const_value(bc_ins(s, r)), n);
}

static void add_number(Select *s, IrRef a, int32_t n)
{
    bc_to_x(s, a);
    bc_keep_x(s);
    if (n < 0)
        bc_change_x(s, SMVM_subi, (uint32_t)-n);
    else
        bc_change_x(s, SMVM_addi, (uint32_t)n);
}

static void compute_add(Select *s, IrRef a, IrRef b)
{
    int32_t n;

    if (is_whole(s, b, &n) && n > -(int32_t)SMVM_VARINT_END) {
        add_number(s, a, n);
    } else if (is_whole(s, a, &n) && n > -(int32_t)SMVM_VARINT_END) {
        add_number(s, b, n);
    } else {
        bc_operands(s, a, b, true, true);
        bc_change_x(s, SMVM_add, 0);
    }
}

// a - b where only a can be loaded: computed as -b + a, which is the same number.
static void compute_turned_sub(Select *s, IrRef a, IrRef b)
{
    bc_to_x(s, b);
    bc_keep_x(s);
    bc_change_x(s, SMVM_neg, 0);
    bc_load_y(s, place_of(s, a));
    used(s, a);
    bc_change_x(s, SMVM_add, 0);
}

static void compute_sub(Select *s, IrRef a, IrRef b)
{
    int32_t n;

    if (is_whole(s, b, &n) && n != 0 && n > -(int32_t)SMVM_VARINT_END) {
        add_number(s, a, -n);
        return;
    }
    if (is_to_come(s, a) && is_to_come(s, b) && bc_depth(s, a) > bc_depth(s, b) + MUCH_DEEPER)
        place(s, a);
    if (x_holds(s, a) && is_to_come(s, b))
        bc_keep_x(s);
    if (place_of(s, a) != BC_NONE && place_of(s, b) == BC_NONE) {
        compute_turned_sub(s, a, b);
    } else {
        bc_operands(s, a, b, false, true);
        bc_change_x(s, SMVM_sub, 0);
    }
}

// ---- operations ----

static uint8_t opcode(IrOp op)
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

uint32_t bc_relation(IrOp op)
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

uint32_t bc_mirrored(uint32_t relation)
{
    return (relation & (SMVM_EQUAL | SMVM_UNORDERED)) | (relation & SMVM_LESS ? (uint32_t)SMVM_GREATER : 0) | (relation & SMVM_GREATER ? (uint32_t)SMVM_LESS : 0);
}

uint32_t bc_contrary(uint32_t relation) { return (SMVM_LESS | SMVM_EQUAL | SMVM_GREATER | SMVM_UNORDERED) & ~relation; }

static void compute_compare(Select *s, const IrIns *i, bool inverted)
{
    const bool turned = bc_operands(s, i->a, i->b, true, true);
    uint32_t relation = turned ? bc_mirrored(bc_relation(i->op)) : bc_relation(i->op);

    bc_change_x(s, SMVM_set, inverted ? bc_contrary(relation) : relation);
}

// Whether the negation of boolean r can be computed at the same cost as r.  With `now`, requests it.
static bool invert(Select *s, IrRef r, bool now)
{
    const IrIns *i = bc_ins(s, r = bc_without_truth(s, r));
    const bool both = i->op == IR_and || i->op == IR_or;

    if (!s->value[r].waits || (!both && ir_op_info[i->op].types != IR_T_COMPARE) || (both && (!invert(s, i->a, now) || !invert(s, i->b, now))))
        return false;
    s->value[r].inverted = s->value[r].inverted != now;
    return true;
}

static void compute_not(Select *s, IrRef a)
{
    if (invert(s, a, false)) {
        invert(s, a, true);
        compute(s, a);
        return;
    }
    bc_to_x(s, a);
    bc_keep_x(s);
    bc_load_y(s, bc_const_operand(s, sm_from_i32(0)));
    bc_change_x(s, SMVM_set, SMVM_EQUAL | SMVM_UNORDERED);
}

// Turns a possible -0 in X into 0 where the integer r becomes a float.  Returns true if that took an instruction.
static bool clean_zero(Select *s, IrRef r, SmType to)
{
    if (!bc_is_float(to) || !s->value[r].minus_zero)
        return false;
    bc_keep_x(s);
    bc_change_x(s, SMVM_cvt, (uint32_t)bc_ins(s, r)->type);
    return true;
}

static void compute_cvt(Select *s, const IrIns *i)
{
    const IrRef r = i->type == SM_BOOL ? bc_source(s, bc_without_truth(s, i->a)) : bc_stored(s, i->a, i->type);

    bc_to_x(s, r);
    if (clean_zero(s, r, i->type) ? bc_is_within(bc_ins(s, r)->type, i->type) : bc_is_exact(s, r, i->type))
        return;
    bc_keep_x(s);
    bc_change_x(s, SMVM_cvt, (uint32_t)i->type);
}

static void compute_logic(Select *s, const IrIns *i, bool inverted)
{
    bc_operands(s, bc_without_truth(s, i->a), bc_without_truth(s, i->b), true, true);
    bc_change_x(s, (i->op == IR_and) != inverted ? SMVM_and : SMVM_or, 0);
}

static void compute_two(Select *s, const IrIns *i, IrRef a, IrRef b)
{
    if (i->op == IR_add) {
        compute_add(s, a, b);
    } else if (i->op == IR_sub) {
        compute_sub(s, bc_source(s, a), bc_source(s, b));
    } else {
        bc_operands(s, a, b, i->op != IR_div, true);
        bc_change_x(s, opcode(i->op), 0);
    }
}

static void compute_one(Select *s, const IrIns *i)
{
    bc_to_x(s, i->a);
    bc_keep_x(s);
    bc_change_x(s, opcode(i->op), 0);
}

// Computes an operation into X.
static void compute(Select *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);

    if (i->op == IR_cvt)
        compute_cvt(s, i);
    else if (i->op == IR_stat)
        bc_load_x(s, bc_stat_operand(s, i->var, i->stat));
    else if (i->op == IR_not)
        compute_not(s, bc_without_truth(s, i->a));
    else if (ir_op_info[i->op].types == IR_T_COMPARE)
        compute_compare(s, i, s->value[r].inverted);
    else if (ir_op_info[i->op].types == IR_T_LOGIC)
        compute_logic(s, i, s->value[r].inverted);
    else if (ir_op_info[i->op].operands == 2)
        compute_two(s, i, i->a, i->b);
    else
        compute_one(s, i);
}

// ---- instructions ----

// Whether all later users of r, which is in X, can read it from the variable that the store `at` writes.
static bool finds_home(const Select *s, IrRef r, const Value *at)
{
    const Value *v = &s->value[r];

    return v->placed && v->left > 0 && v->slot == BC_NONE && s->x.value == r && at->again >= v->last;
}

static void select_store(Select *s, const IrIns *i, const Value *at)
{
    const IrRef r = bc_stored(s, i->a, i->type);
    const BcRef d = bc_var_operand(s, i->var);
    bool same = bc_is_exact(s, r, i->type);

    bc_to_x(s, r);
    clean_zero(s, r, i->type);
    if (same && finds_home(s, r, at)) {
        s->value[r].slot = d;
        bc_drop_cvt(s, (uint32_t)i->type);
        same = s->x.value == r;
    }
    bc_store_x(s, d, same && !s->value[r].minus_zero);           // if X can be -0, the variable is 0
}

static void select_sample(Select *s, const IrIns *i)
{
    const IrRef r = bc_source(s, i->a);

    bc_to_x(s, r);
    clean_zero(s, r, s->m->ir->window.at[i->var].type);
    bc_sample_x(s, s->m->window_number[i->var]);
}

void bc_select_ins(Select *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);
    const Value *v = &s->value[r];

    s->span = i->span;
    if (i->op == IR_store)
        select_store(s, i, v);
    else if (i->op == IR_sample)
        select_sample(s, i);
    else if (v->uses > 0 && !v->waits && i->op != IR_const && (i->op != IR_load || v->early))
        place(s, r);
}
