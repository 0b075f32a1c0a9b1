// SPDX-License-Identifier: Apache-2.0
// simplify_cfg:
//   a branch on a constant becomes a jump
//   a branch on `not c` becomes a branch on c with its targets swapped
//   a jump to an empty block that only jumps on goes directly to that block's target
//   a block whose single predecessor has it as its only successor is merged into that predecessor
//   unreachable blocks are dropped
// Conditionals stay properly nested, because no path is added and paths only become shorter.
// Needs no facts; invalidates use counts, because conditions lose their user.
#include "compiler/passes/pass.h"

// Simplifies a branch.  On `not c`, swaps the targets and branches on c.  A branch on a constant, or whose targets are equal, becomes a
// jump.
static void simplify_branch(const IrFn *f, IrJump *j)
{
    const IrIns *cond;

    if (j->kind != IR_BR)
        return;
    for (cond = &f->ins.at[j->cond]; cond->op == IR_not; cond = &f->ins.at[j->cond]) {
        IrBlkRef then = j->then;
        j->then = j->otherwise;
        j->otherwise = then;
        j->cond = cond->a;
    }
    if (cond->op == IR_const && cond->bits == 0)
        j->then = j->otherwise;
    if (cond->op == IR_const || j->then == j->otherwise) {
        j->kind = IR_JMP;
        j->cond = j->otherwise = IR_NONE;
    }
}

// Redirects jumps to empty blocks.  Walks from the last block to the first, so that the final target of a jump to any later block is known.
static void simplify_jumps(Arena *work, IrFn *f)
{
    IrBlkRef *final_target = ARENA_ARRAY(work, IrBlkRef, f->blk.n);

    for (size_t b = f->blk.n; b-- > 0;) {
        IrJump *j = &f->blk.at[b].jump;
        if (j->kind == IR_JMP || j->kind == IR_BR)
            j->then = final_target[j->then];
        if (j->kind == IR_BR)
            j->otherwise = final_target[j->otherwise];
        simplify_branch(f, j);
        final_target[b] = j->kind == IR_JMP && f->blk.at[b].ins.n == 0 ? j->then : (IrBlkRef)b;
    }
}

// Appends to b the code of successors that have no other predecessor.
static void merge_successors(Arena *arena, IrFn *f, IrBlkRef b, uint32_t *predecessors)
{
    IrBlk *blk = &f->blk.at[b];

    while (blk->jump.kind == IR_JMP && predecessors[blk->jump.then] == 1) {
        IrBlkRef next = blk->jump.then;
        for (size_t i = 0; i < f->blk.at[next].ins.n; i++)
            vec_push(arena, &blk->ins, f->blk.at[next].ins.at[i]);
        blk->jump = f->blk.at[next].jump;
        predecessors[next] = 0;
    }
}

static void remove_unreachable_blocks(Arena *work, IrFn *f, const uint32_t *predecessors)
{
    IrBlkRef *number = ARENA_ARRAY(work, IrBlkRef, f->blk.n);
    IrBlkRef n = 0;

    for (size_t b = 0; b < f->blk.n; b++)
        if (predecessors[b] > 0) {
            number[b] = n;
            f->blk.at[n++] = f->blk.at[b];
        }
    f->blk.n = n;
    for (size_t b = 0; b < n; b++) {
        IrJump *j = &f->blk.at[b].jump;
        if (j->kind == IR_JMP || j->kind == IR_BR)
            j->then = number[j->then];
        if (j->kind == IR_BR)
            j->otherwise = number[j->otherwise];
    }
}

// The pass `simplify_cfg`: decides branches on known conditions, removes unreachable blocks, and joins blocks.
void pass_simplify_cfg(Arena *arena, IrFn *f, Facts *facts)
{
    uint32_t *predecessors;

    simplify_jumps(facts->work, f);
    predecessors = ir_count_edges(facts->work, f);
    for (IrBlkRef b = 0; b < f->blk.n; b++)
        if (predecessors[b] > 0)
            merge_successors(arena, f, b, predecessors);
    remove_unreachable_blocks(facts->work, f, predecessors);
}
