// SPDX-License-Identifier: Apache-2.0
// dse: drops a store that the same block overwrites before anybody reads it.  What is seen of a step is what variables hold
// at its end and which elements were stored: the store behind it leaves the same.
// Needs uses, for a load whose result nobody uses reads nothing; keeps them right while it works.
#include "compiler/passes/pass.h"

// Whether the store is needed; walking backwards, a note tells that a store follows with no load in between.
static bool is_needed(Facts *facts, const IrIns *i)
{
    VarNote *note = notes_of(facts->notes, i->var);
    bool needed = !note->stored;

    note->stored = true;
    return needed;
}

static bool keep(const IrFn *f, IrRef ref, Facts *facts)
{
    const IrIns *i = &f->ins.at[ref];

    if (i->op == IR_load && facts->uses[ref] > 0)
        notes_of(facts->notes, i->var)->stored = false;
    if (i->op != IR_store || is_needed(facts, i))
        return true;
    facts->uses[i->a]--;
    return false;
}

static void clean_block(const IrFn *f, IrBlk *blk, Facts *facts)
{
    uint32_t kept = blk->ins.n, n = 0;

    notes_begin_block(facts->notes);
    for (size_t p = blk->ins.n; p-- > 0;)                      // the needed end up at the end of the list
        if (keep(f, blk->ins.at[p], facts))
            blk->ins.at[--kept] = blk->ins.at[p];
    while (kept < blk->ins.n)
        blk->ins.at[n++] = blk->ins.at[kept++];
    blk->ins.n = n;
}

void pass_dse(Arena *arena, IrFn *f, Facts *facts)
{
    (void)arena;
    for (size_t b = 0; b < f->blk.n; b++)
        clean_block(f, &f->blk.at[b], facts);
}
