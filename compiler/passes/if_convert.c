// SPDX-License-Identifier: Apache-2.0
// if_convert: replaces conditionals that only choose a value by code without a branch, which a processor would have to predict.
//   if p > 775 { open = true } else: open = false     becomes open = p > 775
//   if p > 775: n = n + 1                             becomes n = n + (p > 775), for a local n that only the machine writes
// A conditional is converted if both arms lead to the same block and contain only stores of boolean constants, counts by one, and the
// operations that these need.  If a boolean is stored in one arm, it must also be stored in the other.  A counter must be a local: code
// without a branch stores it in every case, and an element must only be stored where the source stores it.
// Only emitted C profits: on the VM the addition costs as much as the branch.  With numbers in software the counts stay branches, because
// an 8-bit chip does not predict branches, and adds 64-bit numbers slowly.
// Needs no facts; invalidates use counts.
#include "compiler/ir/eval.h"
#include "compiler/passes/pass.h"

enum { ARM_INS = 32, ARM_STORES = 8 };       // most instructions and stores of an arm: for a larger one a branch is faster

// A store of an arm: of a boolean constant, or of the variable's value plus or minus `one`.
typedef struct ArmStore {
    uint32_t var;
    bool stored_bool;         // the boolean constant that is stored
    IrRef store, one;         // the store instruction; the constant 1, or IR_NONE if a boolean is stored
} ArmStore;

typedef struct Arm {                  // one of the two arms of a conditional
    ArmStore at[ARM_STORES];
    unsigned n;
    IrBlkRef blk, to;         // to: the block after the arm; IR_NONE is the function's end
} Arm;

typedef struct IfConvert {
    Arena *arena;
    const IrMachine *m;
    IrFn *f;
    uint32_t *preds;          // by block: number of incoming edges
    bool counts;              // counts by one are converted, too
} IfConvert;

// Whether adding 0 in `type` leaves every value of a counter unchanged.  That is true of a 64-bit counter in F64: each of its values, the
// initial one included, was converted from an F64 when it was stored.  So a store converts the nearest F64 of the value back to the value,
// also where storing has clamped it: INT64_MAX is read as 2^63, which is stored as INT64_MAX.  Narrower counters are only matched if the pass
// `narrow` has made their addition an integer operation; without narrow (-O0), the branch stays.
static bool can_count_in(SmType type, SmType counter)
{
    if (sm_type_info[counter].bytes == 8)
        return type == counter || type == SM_F64;
    return type == counter || (ir_is_integer(type) && ir_integer_contains(type, counter));
}

// Returns the temporary from which r was converted, through conversions that preserve every value of a counter of this type.
static IrRef skip_conversions(const IrFn *f, IrRef r, SmType counter)
{
    while (f->ins.at[r].op == IR_cvt && can_count_in(f->ins.at[r].type, counter))
        r = f->ins.at[r].a;
    return r;
}

// Whether x is the value of variable `var`, and `one` is the constant 1.  Sets s->one to that constant.
static bool match_plus_one(const IfConvert *c, uint32_t var, IrRef x, IrRef one, ArmStore *s)
{
    const SmType type = c->m->var.at[var].type;
    const IrIns *value = &c->f->ins.at[skip_conversions(c->f, x, type)], *i;

    s->one = skip_conversions(c->f, one, type);
    i = &c->f->ins.at[s->one];
    return value->op == IR_load && value->var == var
        && i->op == IR_const && i->type != SM_BOOL && i->bits == ir_cell(i->type, sm_from_i32(1));
}

// Whether `store` counts its variable up or down by one; then sets s->one.  The variable must be a local that no other code writes, because
// it will be stored when the condition is false, too.
static bool match_count(const IfConvert *c, const IrIns *store, ArmStore *s)
{
    const IrVar *v = &c->m->var.at[store->var];
    const IrIns *sum = &c->f->ins.at[skip_conversions(c->f, store->a, v->type)];

    if (!c->counts || v->space != IR_LOCAL || v->outside || !ir_is_integer(v->type) || !can_count_in(sum->type, v->type))
        return false;
    if (sum->op != IR_add && sum->op != IR_sub)
        return false;
    return match_plus_one(c, store->var, sum->a, sum->b, s) || (sum->op == IR_add && match_plus_one(c, store->var, sum->b, sum->a, s));
}

static const ArmStore *find_store(const Arm *arm, uint32_t var)
{
    for (unsigned i = 0; i < arm->n; i++)
        if (arm->at[i].var == var)
            return &arm->at[i];
    return NULL;
}

// Adds a store to the arm.  Returns false if the block cannot be an arm: the store is neither of a boolean constant nor a count, the arm is
// full, or it already stores to the variable.
static bool try_add_arm_store(const IfConvert *c, IrRef r, Arm *arm)
{
    const IrIns *store = &c->f->ins.at[r], *value = &c->f->ins.at[store->a];
    ArmStore *s = &arm->at[arm->n];

    if (arm->n == ARM_STORES || find_store(arm, store->var))
        return false;
    s->var = store->var;
    s->store = r;
    arm->n++;
    if (value->op == IR_const && value->type == SM_BOOL) {
        s->one = IR_NONE;
        s->stored_bool = value->bits != 0;
        return true;
    }
    return match_count(c, store, s);
}

// Fills in the arm from block b.  Returns false if the block cannot be an arm.
static bool match_arm(const IfConvert *c, IrBlkRef b, Arm *arm)
{
    const IrBlk *blk = &c->f->blk.at[b];
    bool fits = c->preds[b] == 1 && blk->ins.n <= ARM_INS && (blk->jump.kind == IR_RET || blk->jump.kind == IR_JMP);

    arm->n = 0;
    arm->blk = b;
    arm->to = blk->jump.kind == IR_JMP ? blk->jump.then : IR_NONE;
    for (size_t p = 0; fits && p < blk->ins.n; p++) {
        switch (c->f->ins.at[blk->ins.at[p]].op) {
        case IR_const: case IR_load: case IR_cvt: case IR_add: case IR_sub: break;
        case IR_store: fits = try_add_arm_store(c, blk->ins.at[p], arm); break;
        default: fits = false; break;
        }
    }
    return fits;
}

// Whether `other` also stores every boolean variable that `arm` stores, and counts none of the counters of `arm`.
static bool arms_agree(const Arm *arm, const Arm *other)
{
    for (unsigned i = 0; i < arm->n; i++)
        if ((find_store(other, arm->at[i].var) != NULL) != (arm->at[i].one == IR_NONE))
            return false;
    return true;
}

// Finds the arms of the conditional that ends block b, one of which can be empty.  Returns whether it can be converted.
static bool match_arms(const IfConvert *c, IrBlkRef b, Arm *then, Arm *other)
{
    const IrJump *j = &c->f->blk.at[b].jump;
    bool is_then, is_other;

    if (j->kind != IR_BR)
        return false;
    is_then = match_arm(c, j->then, then);
    is_other = match_arm(c, j->otherwise, other);
    if (is_then && then->to == j->otherwise)
        other->n = 0, other->to = then->to, is_other = true;
    else if (is_other && other->to == j->then)
        then->n = 0, then->to = other->to, is_then = true;
    return is_then && is_other && then->to == other->to && then->n + other->n > 0 && arms_agree(then, other) && arms_agree(other, then);
}

// ---- converting ----

// Moves the operations of the arm to the end of block b.  The constant `one` of a count becomes the conversion of `cond` to a number: 1 if
// cond is true, else 0.
static void move_computations(IfConvert *c, IrBlkRef b, const Arm *arm, IrRef cond)
{
    IrBlk *from = &c->f->blk.at[arm->blk];

    if (arm->n == 0)
        return;
    for (unsigned i = 0; i < arm->n; i++)
        if (arm->at[i].one != IR_NONE) {
            IrIns *one = &c->f->ins.at[arm->at[i].one];
            one->op = IR_cvt;
            one->a = cond;
        }
    for (size_t p = 0; p < from->ins.n; p++)
        if (c->f->ins.at[from->ins.at[p]].op != IR_store)
            vec_push(c->arena, &c->f->blk.at[b].ins, from->ins.at[p]);
    from->ins.n = 0;
}

// Moves the stores of booleans, which both arms have, to block b.  If the arms store different constants, stores the condition or its
// negation instead.
static void move_bool_stores(IfConvert *c, IrBlkRef b, const Arm *then, const Arm *other, IrRef cond, IrRef negated)
{
    for (unsigned i = 0; i < then->n; i++) {
        const ArmStore *s = &then->at[i];
        if (s->one != IR_NONE)
            continue;
        if (find_store(other, s->var)->stored_bool != s->stored_bool)
            c->f->ins.at[s->store].a = s->stored_bool ? cond : negated;
        vec_push(c->arena, &c->f->blk.at[b].ins, s->store);
    }
}

// Moves the stores of an arm that count by one to the end of block b.
static void move_count_stores(IfConvert *c, IrBlkRef b, const Arm *arm)
{
    for (unsigned i = 0; i < arm->n; i++)
        if (arm->at[i].one != IR_NONE)
            vec_push(c->arena, &c->f->blk.at[b].ins, arm->at[i].store);
}

static void convert_branch(IfConvert *c, IrBlkRef b, const Arm *then, const Arm *other)
{
    const IrRef cond = c->f->blk.at[b].jump.cond;
    const IrIns negation = {.op = IR_not, .type = SM_BOOL, .a = cond, .b = IR_NONE, .span = c->f->ins.at[cond].span};
    const IrRef negated = ir_emit(c->arena, c->f, b, negation);
    IrJump *j;

    move_computations(c, b, then, cond);
    move_computations(c, b, other, negated);
    move_bool_stores(c, b, then, other, cond, negated);
    move_count_stores(c, b, then);
    move_count_stores(c, b, other);
    j = &c->f->blk.at[b].jump;
    j->kind = then->to == IR_NONE ? IR_RET : IR_JMP;
    j->then = then->to;
    j->cond = j->otherwise = IR_NONE;
}

// The pass `if_convert`: replaces conditionals that only choose a boolean, or count by one, with code without a branch.
void pass_if_convert(Arena *arena, IrFn *f, Facts *facts)
{
    IfConvert c = {arena, facts->m, f, ir_count_edges(facts->work, f), !facts->soft};
    Arm then, other;

    for (IrBlkRef b = (IrBlkRef)f->blk.n; b-- > 0;)
        if (c.preds[b] > 0 && match_arms(&c, b, &then, &other))      // an unreachable block must not take the arms of a reachable one
            convert_branch(&c, b, &then, &other);
}
