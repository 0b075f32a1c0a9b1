// SPDX-License-Identifier: Apache-2.0
// dce: drops operations whose results are unused.  It walks backwards, so that one walk drops whole expressions.
// Needs uses and updates them.
#include "compiler/passes/pass.h"

static bool is_dead(const IrIns *i, uint32_t uses)
{
    return uses == 0 && !ir_op_info[i->op].effect;
}

static void release_operands(const IrIns *i, uint32_t *uses)
{
    if (ir_op_info[i->op].operands > 0)
        uses[i->a]--;
    if (ir_op_info[i->op].operands > 1)
        uses[i->b]--;
}

static void clean_block(const IrFn *f, IrBlk *blk, uint32_t *uses)
{
    uint32_t kept = blk->ins.n, n = 0;

    for (size_t i = blk->ins.n; i-- > 0;) {                  // live instructions are collected at the end of the list
        const IrIns *ins = &f->ins.at[blk->ins.at[i]];
        if (is_dead(ins, uses[blk->ins.at[i]]))
            release_operands(ins, uses);
        else
            blk->ins.at[--kept] = blk->ins.at[i];
    }
    while (kept < blk->ins.n)
        blk->ins.at[n++] = blk->ins.at[kept++];
    blk->ins.n = n;
}

void pass_dce(Arena *arena, IrFn *f, Facts *facts)
{
    (void)arena;
    for (size_t b = 0; b < f->blk.n; b++)
        clean_block(f, &f->blk.at[b], facts->uses);
}
