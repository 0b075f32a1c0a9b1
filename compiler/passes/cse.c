// SPDX-License-Identifier: Apache-2.0
// cse: common subexpression elimination within a block, by value numbering.  The value number of a temporary is the first temporary that
// certainly has the same value: the same operation on operands with the same value numbers.  A load has the value of the last store to its
// variable in the block, or of the last load.  This is correct because a stored value is never NaN and is of the variable's type, so
// loading it returns the same bits (ir.h).  Operands of add, mul, eq, ne, min, max, and, or are sorted by value number.  This is correct
// because the bits of a NaN are not observable, and min and max treat -0 and +0 the same in both operand orders.
//
// Not every repeated operation is worth a temporary.  An operation is "sunk" if its only user is a store or a branch.  Both backends
// compute a sunk operation in place, without a temporary.  So a repeated operation is replaced by the earlier one only if neither is
// sunk.  Constants are always replaced, and so are window statistics and square roots, which cost more than a copy.  A conversion to F64
// that changes nothing is free and is not replaced.  A load after a store stays a load, because the variable already contains the value.
//
// A store of the value that the variable already has is dropped.  For an element, this requires an earlier store in the block, because
// other code can observe that an element was stored.  For a local, it requires that only the machine writes the local.
// Needs use counts (FACT_USES) and updates them.
#include <string.h>

#include "compiler/ir/comparison.h"
#include "compiler/passes/pass.h"
#include "stdlib/f64.h"

typedef struct CseSlot { uint32_t block; IrRef ref; } CseSlot;      // empty unless `block` equals Cse.block

typedef struct Cse {
    IrFn *f;
    Facts *facts;
    IrRef *value;             // by instruction: its value number, which is the first instruction of the same value
    IrRef *leader;            // by value number: the instruction that replaces the others of that value
    IrRef *same;              // by instruction: the temporary that its users must use instead
    bool *sunk;               // by instruction: its only user is a store or a branch
    CseSlot *table;           // hash table of the block's operations, by CseKey
    size_t cap;               // number of slots of `table`, a power of two
    uint32_t block;           // number of the current block, from 1
} Cse;

static IrIns *ins_at(const Cse *c, IrRef ref) { return &c->f->ins.at[ref]; }

// ---- when two operations have the same value ----

typedef struct CseKey { IrOp op; SmType type; IrRef a, b; uint32_t var; uint64_t bits; } CseKey;

static void swap_operands(CseKey *k)
{
    IrRef a = k->a;

    k->a = k->b;
    k->b = a;
}

// Returns the key of an operation.  Two operations of a block with equal keys have the same value.
static CseKey key_of(const Cse *c, const IrIns *i)
{
    CseKey k = {i->op, i->type, IR_NONE, IR_NONE, 0, 0};

    if (ir_op_info[i->op].operands > 0)
        k.a = c->value[i->a];
    if (ir_op_info[i->op].operands > 1)
        k.b = c->value[i->b];
    if (i->op == IR_gt || i->op == IR_ge) {                   // a > b has the key of b < a
        k.op = ir_swapped_comparison(i->op);
        swap_operands(&k);
    } else if (ir_op_info[i->op].commutes && k.b < k.a) {
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

static size_t hash_key(const CseKey *k)
{
    uint64_t h = k->bits * UINT64_C(0x9e3779b97f4a7c15) ^ (uint64_t)k->op << 8 ^ (uint64_t)k->type;

    h = (h ^ h >> 29 ^ (uint64_t)k->a << 32 ^ k->b) * UINT64_C(0xbf58476d1ce4e5b9);
    return (size_t)((h ^ h >> 32 ^ k->var) * UINT64_C(0x94d049bb133111eb) >> 32);
}

// Returns the first operation of the block with the same key as `ref`.  If no operation has that key, adds `ref` to the table and returns it.
static IrRef find_or_add_operation(Cse *c, IrRef ref)
{
    CseKey k = key_of(c, ins_at(c, ref)), other;
    size_t at = hash_key(&k) & (c->cap - 1);

    for (; c->table[at].block == c->block; at = (at + 1) & (c->cap - 1)) {
        other = key_of(c, ins_at(c, c->table[at].ref));
        if (k.op == other.op && k.type == other.type && k.a == other.a && k.b == other.b && k.var == other.var && k.bits == other.bits)
            return c->table[at].ref;
    }
    c->table[at].block = c->block;
    c->table[at].ref = ref;
    return ref;
}

// ---- operations that cost nothing in place ----

// Marks ref as sunk (computed in place by its user, without a temporary) if the current instruction is its only user.
static void mark_sunk_if_used_once(Cse *c, IrRef ref)
{
    c->sunk[ref] = c->facts->uses[ref] == 1;
}

// Fills in `sunk` for a block, from its end.  An operand of a store, of a branch, or of a sunk conversion or logic operation is sunk if it
// has no other user.
static void mark_sunk(Cse *c, const IrBlk *blk)
{
    if (blk->jump.kind == IR_BR)
        mark_sunk_if_used_once(c, blk->jump.cond);
    for (size_t p = blk->ins.n; p-- > 0;) {
        IrRef ref = blk->ins.at[p];
        const IrIns *i = ins_at(c, ref);
        if (i->op == IR_store || (c->sunk[ref] && (i->op == IR_cvt || ir_op_info[i->op].types == IR_T_LOGIC)))
            mark_sunk_if_used_once(c, i->a);
        if (c->sunk[ref] && ir_op_info[i->op].types == IR_T_LOGIC && ir_op_info[i->op].operands > 1)
            mark_sunk_if_used_once(c, i->b);
    }
}

// Whether i is a conversion to F64, for which the backends emit no instruction.
static bool is_free(const Cse *c, const IrIns *i)
{
    return i->op == IR_cvt && i->type == SM_F64 && ins_at(c, i->a)->type != SM_F64;
}

static bool is_expensive(const IrIns *i) { return i->op == IR_stat || i->op == IR_sqrt || ir_is_elementary(i->op); }

// ---- the walk ----

// Replaces a load by the value that the block has stored to or loaded from the variable before, if there is one.
static void visit_load(Cse *c, IrRef ref)
{
    VarNote *note = find_variable_note(c->facts->notes, ins_at(c, ref)->var);

    if (note->ref == IR_NONE)
        note->ref = ref;
    c->value[ref] = note->ref;
    c->leader[ref] = ref;
    if (ins_at(c, note->ref)->op == IR_const)
        c->same[ref] = note->ref;
    else if (note->load != IR_NONE)
        c->same[ref] = note->load;
    else
        note->load = ref;
}

// Updates what is known about the variable.  Returns false if the store can be dropped.
static bool visit_store(Cse *c, const IrIns *i)
{
    VarNote *note = find_variable_note(c->facts->notes, i->var);
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

// Gives an operation the value number of an earlier equal one, and the temporary that its users read instead.
static void visit_operation(Cse *c, IrRef ref)
{
    const IrIns *i = ins_at(c, ref);
    IrRef first = find_or_add_operation(c, ref), leader = c->leader[first];

    c->value[ref] = first;
    if (first == ref)
        c->leader[ref] = ref;
    else if (is_free(c, i))
        return;
    else if (i->op == IR_const || is_expensive(i) || (!c->sunk[ref] && !c->sunk[leader]))
        c->same[ref] = leader;
    else if (c->sunk[leader])
        c->leader[first] = ref;
}

// Returns the temporary that replaces `ref` as an operand, and moves one use in the use counts from `ref` to this temporary.
static IrRef replace_use(Cse *c, IrRef ref)
{
    c->facts->uses[ref]--;
    c->facts->uses[c->same[ref]]++;
    return c->same[ref];
}

// Numbers the value of an instruction.  Returns false if the instruction can be dropped.
static bool visit_instruction(Cse *c, IrRef ref)
{
    IrIns *i = ins_at(c, ref);

    c->same[ref] = c->value[ref] = ref;
    if (ir_op_info[i->op].operands > 0)
        i->a = replace_use(c, i->a);
    if (ir_op_info[i->op].operands > 1)
        i->b = replace_use(c, i->b);
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

    mark_sunk(c, blk);
    notes_begin_block(c->facts->notes);
    for (size_t p = 0; p < blk->ins.n; p++)
        if (visit_instruction(c, blk->ins.at[p]))
            blk->ins.at[kept++] = blk->ins.at[p];
    blk->ins.n = kept;
    if (blk->jump.kind == IR_BR)
        blk->jump.cond = replace_use(c, blk->jump.cond);
}

// The pass `cse`: computes a value once per block, and removes stores of the value that is already stored.
void pass_cse(Arena *arena, IrFn *f, Facts *facts)
{
    size_t n = f->ins.n, longest = 0;
    Arena *work = facts->work;
    Cse c = {.f = f, .facts = facts, .sunk = ARENA_ARRAY(work, bool, n), .cap = 8};

    (void)arena;
    c.value = arena_alloc_unzeroed(work, n * sizeof *c.value);       // of each instruction, written before it is read
    c.leader = arena_alloc_unzeroed(work, n * sizeof *c.leader);
    c.same = arena_alloc_unzeroed(work, n * sizeof *c.same);
    for (size_t b = 0; b < f->blk.n; b++)
        if (f->blk.at[b].ins.n > longest)
            longest = f->blk.at[b].ins.n;
    while (c.cap < 2 * longest)
        c.cap *= 2;
    c.table = ARENA_ARRAY(work, CseSlot, c.cap);
    for (size_t b = 0; b < f->blk.n; b++) {
        c.block = (uint32_t)b + 1;
        visit_block(&c, &f->blk.at[b]);
    }
}
