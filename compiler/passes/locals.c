// SPDX-License-Identifier: Apache-2.0
// locals: what a local does not need memory for.
//   One that nothing stores to is a constant: its initial value.  (A script may write it from outside: then it is none.)
//   A hidden one that nothing reads needs no stores.
//   A hidden one that is only read behind a store in the same block is a name for what was stored: its readers take that.
// A stored value is never NaN and of the variable's type, so loading it gives the very same bits (ir.h).  Loads that nobody uses
// count as readers: run dce before.  Needs nothing; breaks uses.
#include "compiler/passes/pass.h"

typedef struct Local {
    bool stored, loaded;
    bool exposed;             // some load may see what an earlier block or step left, or the temporary stored is not all of it
    uint32_t block;           // the last block that stored it, and what
    IrRef held;
} Local;

typedef struct Locals {
    IrMachine *m;
    Local *at;                // by variable
    uint32_t block;           // all blocks of the machine, counted from 1
    IrRef *same;              // by instruction of a function: what its users name from now on
} Locals;

// Of an operation narrowed to F32 only the F32 may be asked for, as a store does; readers of the local may ask for more.
static bool is_f32_operation(const IrIns *i) { return i->type == SM_F32 && ir_op_info[i->op].types == IR_T_SAME; }

static void note_ins(Locals *l, const IrFn *f, const IrIns *i)
{
    Local *v = &l->at[i->var];

    if (i->op == IR_store) {
        v->stored = true;
        v->block = l->block;
        v->exposed |= is_f32_operation(&f->ins.at[i->a]);
    } else if (i->op == IR_load) {
        v->loaded = true;
        v->exposed |= v->block != l->block;
    }
}

static void note_function(Locals *l, const IrFn *f)
{
    for (size_t b = 0; b < f->blk.n; b++) {
        l->block++;
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++) {
            const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[p]];
            if (i->op == IR_store || i->op == IR_load)
                note_ins(l, f, i);
        }
    }
}

static bool is_constant(const Locals *l, uint32_t var)
{
    const IrVar *v = &l->m->var.at[var];

    return v->space == IR_LOCAL && !v->outside && !l->at[var].stored;
}

static bool needs_no_memory(const Locals *l, uint32_t var)
{
    return l->m->var.at[var].hidden && !l->at[var].exposed;
}

// False if the instruction can go.
static bool visit_load(Locals *l, IrIns *i, IrRef ref)
{
    if (is_constant(l, i->var)) {
        i->op = IR_const;
        i->bits = l->m->var.at[i->var].init;
    } else if (needs_no_memory(l, i->var)) {
        l->same[ref] = l->at[i->var].held;
        return false;
    }
    return true;
}

static bool visit(Locals *l, IrFn *f, IrRef ref)
{
    IrIns *i = &f->ins.at[ref];

    l->same[ref] = ref;
    if (ir_op_info[i->op].operands > 0)
        i->a = l->same[i->a];
    if (ir_op_info[i->op].operands > 1)
        i->b = l->same[i->b];
    if (i->op == IR_load)
        return visit_load(l, i, ref);
    if (i->op != IR_store || !needs_no_memory(l, i->var))
        return true;
    l->at[i->var].held = i->a;
    return false;
}

static void clean_function(Arena *arena, Locals *l, IrFn *f)
{
    l->same = ARENA_ARRAY(arena, IrRef, f->ins.n);
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk *blk = &f->blk.at[b];
        uint32_t kept = 0;
        for (size_t p = 0; p < blk->ins.n; p++)
            if (visit(l, f, blk->ins.at[p]))
                blk->ins.at[kept++] = blk->ins.at[p];
        blk->ins.n = kept;
        if (blk->jump.kind == IR_BR)
            blk->jump.cond = l->same[blk->jump.cond];
    }
}

static bool has_something_to_do(const Locals *l)
{
    for (uint32_t v = 0; v < l->m->var.n; v++)
        if ((is_constant(l, v) && l->at[v].loaded) || (needs_no_memory(l, v) && l->at[v].stored))
            return true;
    return false;
}

void pass_locals(Arena *arena, IrMachine *m, FactMachine *values)
{
    Locals l = {m, ARENA_ARRAY(arena, Local, m->var.n), 0, NULL};

    (void)values;
    if (m->sample)
        note_function(&l, m->sample);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            if (m->state.at[s].block[k])
                note_function(&l, m->state.at[s].block[k]);
    if (!has_something_to_do(&l))
        return;
    if (m->sample)
        clean_function(arena, &l, m->sample);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            if (m->state.at[s].block[k])
                clean_function(arena, &l, m->state.at[s].block[k]);
}
