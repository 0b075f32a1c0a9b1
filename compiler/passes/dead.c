// SPDX-License-Identifier: Apache-2.0
// dce: drops operations whose results are unused.
// dse: drops a store that the same block overwrites before any load reads it.  Only two effects of a step are observable: the values of
// variables at its end, and which elements were stored.  The later store produces both.  A load whose result is unused is no read.
// Both passes walk backwards, so that one walk drops whole expressions.  They need use counts (FACT_USES) and update them.
#include "compiler/passes/pass.h"

// Decides whether an instruction stays.  Called for each instruction of a block, from the last to the first.  If the instruction does not
// stay, the function subtracts one from the use counts of its operands.
typedef bool VisitFn(const IrFn *f, IrRef ref, Facts *facts);

// Removes the instructions of a block for which `visit` returns false.
static void filter_block(const IrFn *f, IrBlk *blk, Facts *facts, VisitFn *visit)
{
    uint32_t kept = blk->ins.n, n = 0;

    notes_begin_block(facts->notes);
    for (size_t p = blk->ins.n; p-- > 0;)                      // instructions that stay are collected at the end of the list
        if (visit(f, blk->ins.at[p], facts))
            blk->ins.at[--kept] = blk->ins.at[p];
    if (kept == 0)                                             // all stay
        return;
    while (kept < blk->ins.n)
        blk->ins.at[n++] = blk->ins.at[kept++];
    blk->ins.n = n;
}

// Returns whether the instruction stays: its result is used, or it has an effect.
static bool visit_for_dce(const IrFn *f, IrRef ref, Facts *facts)
{
    const IrIns *i = &f->ins.at[ref];

    if (facts->uses[ref] > 0 || ir_op_info[i->op].effect)
        return true;
    if (ir_op_info[i->op].operands > 0)
        facts->uses[i->a]--;
    if (ir_op_info[i->op].operands > 1)
        facts->uses[i->b]--;
    return false;
}

// Returns whether the instruction stays.  VarNote.stored is set if a later store of the block overwrites the variable and no load between
// the current position and that store reads it.
static bool visit_for_dse(const IrFn *f, IrRef ref, Facts *facts)
{
    const IrIns *i = &f->ins.at[ref];

    if (i->op == IR_load && facts->uses[ref] > 0)
        find_variable_note(facts->notes, i->var)->stored = false;
    if (i->op != IR_store)
        return true;
    if (find_variable_note(facts->notes, i->var)->stored) {
        facts->uses[i->a]--;
        return false;
    }
    find_variable_note(facts->notes, i->var)->stored = true;
    return true;
}

// The pass `dce`: removes operations whose results are not used.
void pass_dce(Arena *arena, IrFn *f, Facts *facts)
{
    (void)arena;
    for (size_t b = 0; b < f->blk.n; b++)
        filter_block(f, &f->blk.at[b], facts, visit_for_dce);
}

// The pass `dse`: removes stores that the same block overwrites before they are read.
void pass_dse(Arena *arena, IrFn *f, Facts *facts)
{
    (void)arena;
    for (size_t b = 0; b < f->blk.n; b++)
        filter_block(f, &f->blk.at[b], facts, visit_for_dse);
}
