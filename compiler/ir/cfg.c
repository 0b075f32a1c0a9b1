// SPDX-License-Identifier: Apache-2.0
// Analyses of the control-flow graph of a function.  Jumps only lead to blocks with a higher number, so each analysis visits every block
// once, in ascending or descending order.
#include "compiler/ir/ir.h"

// Returns for each block whether it is reachable from the first block.
bool *ir_find_reachable(Arena *arena, const IrFn *f)
{
    bool *reached = ARENA_ARRAY(arena, bool, f->blk.n);

    reached[0] = true;
    for (size_t b = 0; b < f->blk.n; b++) {
        const IrJump *j = &f->blk.at[b].jump;
        if (reached[b] && (j->kind == IR_JMP || j->kind == IR_BR))
            reached[j->then] = true;
        if (reached[b] && j->kind == IR_BR)
            reached[j->otherwise] = true;
    }
    return reached;
}

// Returns for each block the number of edges into it from reachable blocks.
uint32_t *ir_count_edges(Arena *arena, const IrFn *f)
{
    uint32_t *n = ARENA_ARRAY(arena, uint32_t, f->blk.n);
    const bool *reached = ir_find_reachable(arena, f);

    for (size_t b = 0; b < f->blk.n; b++) {
        const IrJump *j = &f->blk.at[b].jump;
        if (reached[b] && (j->kind == IR_JMP || j->kind == IR_BR))
            n[j->then]++;
        if (reached[b] && j->kind == IR_BR)
            n[j->otherwise]++;
    }
    n[0]++;
    return n;
}

// Returns the nearest common postdominator of x and y.  A postdominator has a higher number than the blocks that it postdominates.
// IR_NONE, the function's end, is the highest number.
static IrBlkRef common_postdominator(const IrBlkRef *post, IrBlkRef x, IrBlkRef y)
{
    while (x != y) {
        if (x < y)
            x = post[x];
        else
            y = post[y];
    }
    return x;
}

// Returns for each block its immediate postdominator: the nearest block on every path from it to the function's end; IR_NONE is the end.
IrBlkRef *ir_find_postdominators(Arena *arena, const IrFn *f)
{
    IrBlkRef *post = ARENA_ARRAY(arena, IrBlkRef, f->blk.n);

    for (size_t b = f->blk.n; b-- > 0;) {
        const IrJump *j = &f->blk.at[b].jump;
        switch (j->kind) {
        case IR_RET:
        case IR_GOTO: post[b] = IR_NONE; break;
        case IR_JMP: post[b] = j->then; break;
        case IR_BR: post[b] = common_postdominator(post, j->then, j->otherwise); break;
        }
    }
    return post;
}
