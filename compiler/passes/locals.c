// SPDX-License-Identifier: Apache-2.0
// locals: removes accesses to locals that need no memory.
//   A local that no code of the machine or a script stores to is a constant: its initial value.  A parameter is not.
//   A hidden local (one that no code outside the machine reads) that is never loaded needs no stores.
//   A hidden local that is only loaded after a store in the same block needs no memory: its loads are replaced by the stored value.
// A stored value is never NaN and is of the variable's type, so loading it returns the same bits (ir.h).  Loads whose results are
// unused count as reads, so dce must run first.  Needs no facts; invalidates use counts.
#include "compiler/passes/pass.h"

typedef struct LocalUse {
    bool stored, loaded;
    bool exposed;             // a load may read the value of an earlier block or step, or a stored temporary cannot replace its loads
    uint32_t block;           // number of the last block that stored to the local
    IrRef stored_temp;        // the temporary that the last store of that block stored
} LocalUse;

typedef struct LocalsPass {
    IrMachine *m;
    LocalUse *at;             // at[variable]: how functions access it
    uint32_t block;           // the current block; counts all blocks of the machine from 1
    IrRef *same;              // by instruction of a function: the temporary that its users must use instead
} LocalsPass;

// Whether i is narrowed to F32.  Users may only read the F32 conversion of its result (ir.h).  A store does so, but a user that gets the
// result instead of a load might not.  So such a result cannot replace loads.
static bool is_f32_operation(const IrIns *i) { return i->type == SM_F32 && ir_op_info[i->op].types == IR_T_SAME; }

// Records in l->at how a function accesses each variable.
static void note_accesses(LocalsPass *l, const IrFn *f)
{
    for (size_t b = 0; b < f->blk.n; b++) {
        l->block++;
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++) {
            const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[p]];
            LocalUse *v;
            if (i->op != IR_store && i->op != IR_load)
                continue;
            v = &l->at[i->var];
            if (i->op == IR_store) {
                v->stored = true;
                v->block = l->block;
                v->exposed |= is_f32_operation(&f->ins.at[i->a]);
            } else {
                v->loaded = true;
                v->exposed |= v->block != l->block;
            }
        }
    }
}

// Whether the variable always has its initial value: a local that no function stores to and no other code can set.
static bool is_constant(const LocalsPass *l, uint32_t var)
{
    const IrVar *v = &l->m->var.at[var];

    return v->space == IR_LOCAL && !v->outside && !v->parameter && !l->at[var].stored;
}

// Whether every load of the variable follows a store in the same block, so that temporaries can replace it.
static bool needs_no_memory(const LocalsPass *l, uint32_t var)
{
    return l->m->var.at[var].hidden && !l->at[var].exposed;
}

// Returns false if the instruction can be dropped.
static bool visit_instruction(LocalsPass *l, IrFn *f, IrRef ref)
{
    IrIns *i = &f->ins.at[ref];

    l->same[ref] = ref;
    if (ir_op_info[i->op].operands > 0)
        i->a = l->same[i->a];
    if (ir_op_info[i->op].operands > 1)
        i->b = l->same[i->b];
    if (i->op == IR_load && is_constant(l, i->var)) {
        i->op = IR_const;
        i->bits = l->m->var.at[i->var].init;
        return true;
    }
    if ((i->op != IR_load && i->op != IR_store) || !needs_no_memory(l, i->var))
        return true;
    if (i->op == IR_load)
        l->same[ref] = l->at[i->var].stored_temp;
    else
        l->at[i->var].stored_temp = i->a;
    return false;
}

static void remove_accesses(Arena *arena, LocalsPass *l, IrFn *f)
{
    l->same = ARENA_ARRAY(arena, IrRef, f->ins.n);
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk *blk = &f->blk.at[b];
        uint32_t kept = 0;
        for (size_t p = 0; p < blk->ins.n; p++)
            if (visit_instruction(l, f, blk->ins.at[p]))
                blk->ins.at[kept++] = blk->ins.at[p];
        blk->ins.n = kept;
        if (blk->jump.kind == IR_BR)
            blk->jump.cond = l->same[blk->jump.cond];
    }
}

static bool has_removable_access(const LocalsPass *l)
{
    for (uint32_t v = 0; v < l->m->var.n; v++)
        if ((is_constant(l, v) && l->at[v].loaded) || (needs_no_memory(l, v) && l->at[v].stored))
            return true;
    return false;
}

// The pass `locals`: turns locals that are never written into constants, and hidden locals of one block into temporaries.
void pass_locals(Arena *arena, IrMachine *m, FactMachine *values)
{
    LocalsPass l = {m, ARENA_ARRAY(arena, LocalUse, m->var.n), 0, NULL};

    (void)values;
    if (m->sample)
        note_accesses(&l, m->sample);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            if (m->state.at[s].block[k])
                note_accesses(&l, m->state.at[s].block[k]);
    if (!has_removable_access(&l))
        return;
    if (m->sample)
        remove_accesses(arena, &l, m->sample);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            if (m->state.at[s].block[k])
                remove_accesses(arena, &l, m->state.at[s].block[k]);
}
