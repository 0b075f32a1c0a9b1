// SPDX-License-Identifier: Apache-2.0
// Replaces conditionals that only choose a value by code without a jump, which a processor would have to predict.  Where both arms store a
// boolean constant, `if p > 775 { open = true } else: open = false`, the condition itself is stored.  Where an arm counts a local by one,
// the condition is added to it.  A step stores an element only where the source does, because others can write it; a local belongs to the
// machine alone.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

enum { ARM_INS = 32, ARM_STORES = 8 };       // limits of an arm: a larger one is worth a jump

// The effect of an arm on a variable: it stores a boolean, or counts by the constant `one`.
typedef struct Setting {
    uint32_t var;
    bool truth;               // the stored value, unless it counts
    IrRef store, one;         // one: IR_NONE unless it counts
} Setting;

typedef struct Arm {
    Setting at[ARM_STORES];
    unsigned n;
    IrBlkRef blk, to;         // to: the block after the arm; IR_NONE is the function's end
} Arm;

typedef struct Straight {
    Arena *arena;
    const IrMachine *m;
    const IrFn *f;
    IrFn *copy;               // the modified copy of f; NULL as long as nothing has changed
    uint32_t *preds;
    bool counts;
} Straight;

// Whether `type` can represent every value of a counter's type: then x + 0 is x in it.  A stored 64-bit integer is always exactly an F64.
static bool holds(SmType type, SmType counter)
{
    const bool wide = sm_type_info[counter].bytes == 8;

    return type == counter || (wide ? type == SM_F64 : c_is_integer(type) && c_holds_all(type, counter));
}

static IrRef converted(const IrFn *f, IrRef r, SmType counter)
{
    while (f->ins.at[r].op == IR_cvt && holds(f->ins.at[r].type, counter))
        r = f->ins.at[r].a;
    return r;
}

static bool is_one(const IrIns *i)
{
    return i->op == IR_const && i->type != SM_BOOL && i->bits == sm_cell_from_f64(i->type, sm_from_i32(1));
}

// Whether x is the counter's value, and `one` the number one.
static bool counts_by(const Straight *s, uint32_t counter, IrRef x, IrRef one, Setting *set)
{
    const SmType type = s->m->var.at[counter].type;
    const IrIns *value = &s->f->ins.at[converted(s->f, x, type)];

    set->one = converted(s->f, one, type);
    return value->op == IR_load && value->var == counter && is_one(&s->f->ins.at[set->one]);
}

// Whether `store` counts its variable by one, up or down.  The variable must be a local, which can be stored when the condition is false,
// too.
static bool is_count(const Straight *s, const IrIns *store, Setting *set)
{
    const IrVar *v = &s->m->var.at[store->var];
    const IrIns *sum = &s->f->ins.at[converted(s->f, store->a, v->type)];

    if (!s->counts || v->space != IR_LOCAL || v->outside || !c_is_integer(v->type) || !holds(sum->type, v->type))
        return false;
    if (sum->op != IR_add && sum->op != IR_sub)
        return false;
    return counts_by(s, store->var, sum->a, sum->b, set) || (sum->op == IR_add && counts_by(s, store->var, sum->b, sum->a, set));
}

static bool is_truth(const Straight *s, const IrIns *store, Setting *set)
{
    const IrIns *value = &s->f->ins.at[store->a];

    set->one = IR_NONE;
    set->truth = value->bits != 0;
    return value->op == IR_const && value->type == SM_BOOL;
}

static const Setting *find(const Arm *arm, uint32_t var)
{
    for (unsigned i = 0; i < arm->n; i++)
        if (arm->at[i].var == var)
            return &arm->at[i];
    return NULL;
}

static bool add_setting(const Straight *s, IrRef r, Arm *arm)
{
    const IrIns *store = &s->f->ins.at[r];
    Setting *set = &arm->at[arm->n];

    if (arm->n == ARM_STORES || find(arm, store->var))
        return false;
    set->var = store->var;
    set->store = r;
    arm->n++;
    return is_truth(s, store, set) || is_count(s, store, set);
}

// Reads block b as an arm; returns false if it does anything else.
static bool read_arm(const Straight *s, IrBlkRef b, Arm *arm)
{
    const IrBlk *blk = &s->f->blk.at[b];
    bool fits = s->preds[b] == 1 && blk->ins.n <= ARM_INS && (blk->jump.kind == IR_RET || blk->jump.kind == IR_JMP);

    arm->n = 0;
    arm->blk = b;
    arm->to = blk->jump.kind == IR_JMP ? blk->jump.then : IR_NONE;
    for (size_t p = 0; fits && p < blk->ins.n; p++) {
        switch (s->f->ins.at[blk->ins.at[p]].op) {
        case IR_const: case IR_load: case IR_cvt: case IR_add: case IR_sub: break;
        case IR_store: fits = add_setting(s, blk->ins.at[p], arm); break;
        default: fits = false; break;
        }
    }
    return fits;
}

// A variable that an arm sets to a boolean must be set in the other arm, too; a counter must not be stored there.
static bool agree(const Arm *arm, const Arm *other)
{
    for (unsigned i = 0; i < arm->n; i++) {
        const Setting *set = find(other, arm->at[i].var);
        if ((set != NULL) != (arm->at[i].one == IR_NONE))
            return false;
    }
    return true;
}

// Finds the arms of the conditional that ends block b, one of which can be empty.  Returns whether it only chooses values.
static bool find_arms(const Straight *s, IrBlkRef b, Arm *then, Arm *other)
{
    const IrJump *j = &s->f->blk.at[b].jump;
    bool is_then, is_other;

    if (j->kind != IR_BR)
        return false;
    is_then = read_arm(s, j->then, then);
    is_other = read_arm(s, j->otherwise, other);
    if (is_then && then->to == j->otherwise)
        other->n = 0, other->to = then->to, is_other = true;
    else if (is_other && other->to == j->then)
        then->n = 0, then->to = other->to, is_then = true;
    return is_then && is_other && then->to == other->to && then->n + other->n > 0 && agree(then, other) && agree(other, then);
}

// ---- changing ----

static IrFn *copy_of(Arena *arena, const IrFn *f)
{
    IrFn *copy = ARENA_NEW(arena, IrFn);

    for (size_t i = 0; i < f->ins.n; i++)
        vec_push(arena, &copy->ins, f->ins.at[i]);
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk blk = {.jump = f->blk.at[b].jump};
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++)
            vec_push(arena, &blk.ins, f->blk.at[b].ins.at[p]);
        vec_push(arena, &copy->blk, blk);
    }
    return copy;
}

static IrRef negation(Straight *s, IrBlkRef b, IrRef cond)
{
    IrIns i = {.op = IR_not, .type = SM_BOOL, .a = cond, .b = IR_NONE, .span = s->copy->ins.at[cond].span};

    return ir_emit(s->arena, s->copy, b, i);
}

// Moves the arm's computations to the end of block b.  The constant `one` of a counter becomes the conversion of `cond`: 1 if it is true,
// otherwise 0.
static void move_values(Straight *s, IrBlkRef b, const Arm *arm, IrRef cond)
{
    const IrBlk *from = &s->f->blk.at[arm->blk];

    if (arm->n == 0)
        return;
    for (unsigned i = 0; i < arm->n; i++)
        if (arm->at[i].one != IR_NONE) {
            IrIns *one = &s->copy->ins.at[arm->at[i].one];
            one->op = IR_cvt;
            one->a = cond;
        }
    for (size_t p = 0; p < from->ins.n; p++)
        if (s->f->ins.at[from->ins.at[p]].op != IR_store)
            vec_push(s->arena, &s->copy->blk.at[b].ins, from->ins.at[p]);
    s->copy->blk.at[arm->blk].ins.n = 0;
}

static void move_truths(Straight *s, IrBlkRef b, const Arm *then, const Arm *other, IrRef cond, IrRef negated)
{
    for (unsigned i = 0; i < then->n; i++) {
        const Setting *set = &then->at[i];
        if (set->one != IR_NONE)
            continue;
        if (find(other, set->var)->truth != set->truth)
            s->copy->ins.at[set->store].a = set->truth ? cond : negated;
        vec_push(s->arena, &s->copy->blk.at[b].ins, set->store);
    }
}

static void move_counts(Straight *s, IrBlkRef b, const Arm *arm)
{
    for (unsigned i = 0; i < arm->n; i++)
        if (arm->at[i].one != IR_NONE)
            vec_push(s->arena, &s->copy->blk.at[b].ins, arm->at[i].store);
}

static void straighten(Straight *s, IrBlkRef b, const Arm *then, const Arm *other)
{
    const IrRef cond = s->f->blk.at[b].jump.cond;
    IrRef negated;
    IrJump *j;

    if (!s->copy)
        s->copy = copy_of(s->arena, s->f);
    negated = negation(s, b, cond);
    move_values(s, b, then, cond);
    move_values(s, b, other, negated);
    move_truths(s, b, then, other, cond, negated);
    move_counts(s, b, then);
    move_counts(s, b, other);
    j = &s->copy->blk.at[b].jump;
    j->kind = then->to == IR_NONE ? IR_RET : IR_JMP;
    j->then = then->to;
    j->cond = j->otherwise = IR_NONE;
}

const IrFn *fn_straight(CUnit *u, const IrFn *f)
{
    Straight s = {u->arena, u->m, f, NULL, ir_count_ways(u->arena, f), !u->soft};
    Arm then, other;

    for (IrBlkRef b = (IrBlkRef)f->blk.n; b-- > 0;)
        if (s.preds[b] > 0 && find_arms(&s, b, &then, &other))       // an unreachable block must not take arms from others
            straighten(&s, b, &then, &other);
    return s.copy ? s.copy : f;
}
