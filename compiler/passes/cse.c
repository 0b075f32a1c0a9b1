// SPDX-License-Identifier: Apache-2.0
// cse: within a block, what was computed already is not computed again.  Every temporary gets the number of the first one
// that certainly has the same value: the same operation on values of the same numbers.  A load has the value of the last
// store to its variable in the block, or of the last load: a stored value is never NaN and of the variable's type, so that
// loading it gives the very same bits (ir.h).  Operands of add, mul, eq, ne, min, max, and, or may change places: nobody
// sees which NaN comes out, and min and max tell -0 from +0 in either order.
//
// Not every repetition is worth a temporary.  An operation whose only user is a store or a branch costs nothing beside
// itself: both backends compute it right there.  So an operation is left out only if neither it nor the one before is such,
// except statistics of windows and roots, which cost more than a copy.  A conversion to F64 that changes nothing costs
// nothing either.  A load after a store stays a load: the variable is where the value is.
//
// A store of what the variable holds already is dropped: of an element if the block has stored it before (that it was
// stored is seen), of a local unless others write it.
// Needs uses and keeps them right while it works.
#include <string.h>

#include "compiler/passes/pass.h"
#include "stdlib/f64.h"

typedef struct Slot { uint32_t block; IrRef ref; } Slot;      // of a block numbered from 1; of another one it is empty

typedef struct Cse {
    IrFn *f;
    Facts *facts;
    IrRef *value;             // by instruction: the first one of the same value
    IrRef *keeper;            // by such a first one: whom others of the value are replaced by
    IrRef *same;              // by instruction: what its users name from now on
    bool *sunk;               // by instruction: its only user is a store or a branch
    Slot *table;              // operations of the block, by what they are
    size_t cap;               // a power of two
    uint32_t block;
} Cse;

static IrIns *ins_at(const Cse *c, IrRef ref) { return &c->f->ins.at[ref]; }

// ---- what two operations must have in common ----

typedef struct Key { IrOp op; SmType type; IrRef a, b; uint32_t var; uint64_t bits; } Key;

static bool commutes(IrOp op)
{
    return op == IR_add || op == IR_mul || op == IR_eq || op == IR_ne || op == IR_min || op == IR_max || op == IR_and || op == IR_or;
}

static void swap_operands(Key *k)
{
    IrRef a = k->a;

    k->a = k->b;
    k->b = a;
}

static Key key_of(const Cse *c, const IrIns *i)
{
    Key k = {i->op, i->type, IR_NONE, IR_NONE, 0, 0};

    if (ir_op_info[i->op].operands > 0)
        k.a = c->value[i->a];
    if (ir_op_info[i->op].operands > 1)
        k.b = c->value[i->b];
    if (i->op == IR_gt || i->op == IR_ge) {                   // a > b is b < a
        k.op = i->op == IR_gt ? IR_lt : IR_le;
        swap_operands(&k);
    } else if (commutes(i->op) && k.b < k.a) {
        swap_operands(&k);
    }
    if (i->op == IR_const)
        k.bits = i->bits;
    if (i->op == IR_stat) {
        k.var = i->var;
        k.bits = (uint64_t)i->stat;
    }
    return k;
}

static bool same_key(const Key *a, const Key *b)
{
    return a->op == b->op && a->type == b->type && a->a == b->a && a->b == b->b && a->var == b->var && a->bits == b->bits;
}

static size_t hash(const Key *k)
{
    uint64_t h = k->bits * UINT64_C(0x9e3779b97f4a7c15) ^ (uint64_t)k->op << 8 ^ (uint64_t)k->type;

    h = (h ^ h >> 29 ^ (uint64_t)k->a << 32 ^ k->b) * UINT64_C(0xbf58476d1ce4e5b9);
    return (size_t)((h ^ h >> 32 ^ k->var) * UINT64_C(0x94d049bb133111eb) >> 32);
}

// The first operation of the block that is like `ref`: itself if there is none.
static IrRef find(Cse *c, IrRef ref)
{
    Key k = key_of(c, ins_at(c, ref)), other;
    size_t at = hash(&k) & (c->cap - 1);

    for (; c->table[at].block == c->block; at = (at + 1) & (c->cap - 1)) {
        other = key_of(c, ins_at(c, c->table[at].ref));
        if (same_key(&k, &other))
            return c->table[at].ref;
    }
    c->table[at].block = c->block;
    c->table[at].ref = ref;
    return ref;
}

// ---- which operations cost nothing where they are ----

static void sink(Cse *c, IrRef ref)
{
    c->sunk[ref] = c->facts->uses[ref] == 1;
}

// From the block's end: a store's or branch's operand; through conversions and logic on the way to it.
static void find_sunk(Cse *c, const IrBlk *blk)
{
    if (blk->jump.kind == IR_BR)
        sink(c, blk->jump.cond);
    for (size_t p = blk->ins.n; p-- > 0;) {
        IrRef ref = blk->ins.at[p];
        const IrIns *i = ins_at(c, ref);
        if (i->op == IR_store || (c->sunk[ref] && (i->op == IR_cvt || ir_op_info[i->op].types == IR_T_LOGIC)))
            sink(c, i->a);
        if (c->sunk[ref] && ir_op_info[i->op].types == IR_T_LOGIC && ir_op_info[i->op].operands > 1)
            sink(c, i->b);
    }
}

static bool is_free(const Cse *c, const IrIns *i)
{
    return i->op == IR_cvt && i->type == SM_F64 && ins_at(c, i->a)->type != SM_F64;
}

static bool is_dear(const IrIns *i) { return i->op == IR_stat || i->op == IR_sqrt; }

// ---- the walk ----

static void visit_load(Cse *c, IrRef ref)
{
    VarNote *note = notes_of(c->facts->notes, ins_at(c, ref)->var);

    if (note->ref == IR_NONE)
        note->ref = ref;
    c->value[ref] = note->ref;
    c->keeper[ref] = ref;
    if (ins_at(c, note->ref)->op == IR_const)
        c->same[ref] = note->ref;
    else if (note->load != IR_NONE)
        c->same[ref] = note->load;
    else
        note->load = ref;
}

// False if it can go.
static bool visit_store(Cse *c, const IrIns *i)
{
    VarNote *note = notes_of(c->facts->notes, i->var);
    const IrVar *v = &c->facts->m->var.at[i->var];
    bool known = v->space == IR_ELEMENT ? note->stored : !v->outside;

    if (known && note->ref != IR_NONE && note->ref == c->value[i->a]) {
        c->facts->uses[i->a]--;
        return false;
    }
    if (note->ref != c->value[i->a])
        note->load = IR_NONE;
    note->ref = c->value[i->a];
    note->stored = true;
    return true;
}

static void visit_operation(Cse *c, IrRef ref)
{
    const IrIns *i = ins_at(c, ref);
    IrRef first = find(c, ref), keeper = c->keeper[first];

    c->value[ref] = first;
    if (first == ref)
        c->keeper[ref] = ref;
    else if (is_free(c, i))
        return;
    else if (i->op == IR_const || is_dear(i) || (!c->sunk[ref] && !c->sunk[keeper]))
        c->same[ref] = keeper;
    else if (c->sunk[keeper])
        c->keeper[first] = ref;
}

// What a user of `ref` names from now on.
static IrRef renamed(Cse *c, IrRef ref)
{
    c->facts->uses[ref]--;
    c->facts->uses[c->same[ref]]++;
    return c->same[ref];
}

// False if the instruction can go at once.
static bool visit(Cse *c, IrRef ref)
{
    IrIns *i = ins_at(c, ref);

    c->same[ref] = c->value[ref] = ref;
    if (ir_op_info[i->op].operands > 0)
        i->a = renamed(c, i->a);
    if (ir_op_info[i->op].operands > 1)
        i->b = renamed(c, i->b);
    if (i->op == IR_store)
        return visit_store(c, i);
    if (i->op == IR_load)
        visit_load(c, ref);
    else if (i->op != IR_sample)
        visit_operation(c, ref);
    return true;
}

static void visit_block(Cse *c, IrBlk *blk)
{
    uint32_t kept = 0;

    find_sunk(c, blk);
    notes_begin_block(c->facts->notes);
    for (size_t p = 0; p < blk->ins.n; p++)
        if (visit(c, blk->ins.at[p]))
            blk->ins.at[kept++] = blk->ins.at[p];
    blk->ins.n = kept;
    if (blk->jump.kind == IR_BR)
        blk->jump.cond = renamed(c, blk->jump.cond);
}

// Room for twice the operations of the longest block.
static void make_table(Arena *arena, Cse *c)
{
    size_t longest = 0;

    for (size_t b = 0; b < c->f->blk.n; b++)
        if (c->f->blk.at[b].ins.n > longest)
            longest = c->f->blk.at[b].ins.n;
    for (c->cap = 8; c->cap < 2 * longest; c->cap *= 2)
        continue;
    c->table = ARENA_ARRAY(arena, Slot, c->cap);
}

void pass_cse(Arena *arena, IrFn *f, Facts *facts)
{
    size_t n = f->ins.n;
    Cse c = {f, facts, ARENA_ARRAY(arena, IrRef, n), ARENA_ARRAY(arena, IrRef, n), ARENA_ARRAY(arena, IrRef, n), ARENA_ARRAY(arena, bool, n),
             NULL, 0, 0};

    make_table(arena, &c);
    for (size_t b = 0; b < f->blk.n; b++) {
        c.block = (uint32_t)b + 1;
        visit_block(&c, &f->blk.at[b]);
    }
}
