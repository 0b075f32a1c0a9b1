// SPDX-License-Identifier: Apache-2.0
// dse: drops a store that the same block overwrites before any load reads it.  Only two effects of a step are observable: the values
// of variables at its end, and which elements were stored.  The later store produces both.
// Needs uses, because a load whose result is unused does not count as a read.  Updates them.
#include "compiler/passes/pass.h"

// Whether the store is needed.  The walk is backwards: a note means that a store follows with no load in between.
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
    for (size_t p = blk->ins.n; p-- > 0;)                      // needed instructions are collected at the end of the list
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
